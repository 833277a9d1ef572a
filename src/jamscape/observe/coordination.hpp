// How many contacts a grain has, in the countings that give rho_c its alternatives (theory sec. 4 and 6a).
//
//   z       = 2 N_pp/N              N_pp touching pairs of grains, N all grains (walls excluded): the default
//   z_walls = (2 N_pp + N_pw)/N     N_pw wall contacts
//   z_multi = mean contacts, walls counted, of the grains with two or more; 0 where there are none
//   rattlers = fraction of grains with fewer than two contacts, walls counted
//
// Two clusters that touch with several arms are one pair. With a wall every end of an arm is a contact.
#pragma once

#include "jamscape/observe/measure.hpp"

namespace jam {

struct Coordination {
  double z = 0, z_walls = 0, z_multi = 0, rattlers = 0;
};

Coordination coordination(const Bonds& bonds);

Measure coordination_measure();

}  // namespace jam
