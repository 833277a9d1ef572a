// The parts of the page's data, one idea each (web/src/data.ts reads them). A block is null when the results have
// nothing for it. Systems are named by their index in the study.
#pragma once

#include <string>
#include <vector>

#include "jamscape/report/json.hpp"
#include "jamscape/report/pictures.hpp"
#include "jamscape/report/results.hpp"

namespace jam {

/// Title, program, and each system with its options and realisations.
Json study_block(const Results& results);

/// ensemble/transitions.csv, and where each system jams; nothing of containers
Json transitions_block(const Results& results);

/// Published values beside ours, when the study names targets that come with the program.
Json score_block(const Results& results);

/// Every quantity of ensemble/frames.csv over packing fraction.
Json frames_block(const Results& results);

/// What the columns of the table of frames mean, from the registry of measures.
Json columns_block();

/// Which frames of a measure with several rows a frame are shown.
enum class FrameChoice {
  densest,  ///< the one of the largest packing fraction
  even,     ///< several, at even packing fractions
  final     ///< the last one, whether its packing fraction was planned or not
};

struct ManyChoice {
  std::string measure;
  FrameChoice frames;
  double from;     ///< smallest packing fraction shown of discs
  double from_3d;  ///< and of spheres
  double longest;  ///< largest abscissa shown
};

/// The measures shown, and how.
std::vector<ManyChoice> many_choices();

/// ensemble/<measure>.csv
Json many_block(const Results& results, const ManyChoice& choice);

/// The final states of containers: every quantity of ensemble/frames.csv, and those of ensemble/transitions.csv (fits
/// to all realisations pooled), per system; null for other systems.
Json final_block(const Results& results);

/// What the grains of each system are, from its stored frames, or from its options while it has none: shape,
/// sphericity, aspect ratio, volume and so on; null for discs and spheres.
Json shapes_block(const Results& results, const std::vector<PictureSource>& sources);

/// What S3 prints, beside which such results are shown.
Json conzelmann_block();

/// ensemble/level_sets.csv: quantities over packing fraction and force threshold.
Json surfaces_block(const Results& results);

/// Packings and their forces. `force` says which force of a contact is drawn.
Json networks_block(const std::vector<PictureSource>& sources, const MeasureOptions& options);

/// Persistence diagrams of the same packings.
Json diagrams_block(const std::vector<PictureSource>& sources, const MeasureOptions& options);

}  // namespace jam
