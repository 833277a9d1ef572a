// The stages there are. A new one needs its file, its #include and its line here, at the end: options of [[stage]]
// stand in this order, and the names of tasks are made from them.
#pragma once

#include "jamscape/protocol/stages/compress.hpp"
#include "jamscape/protocol/stages/press.hpp"
#include "jamscape/protocol/stages/relax.hpp"
#include "jamscape/protocol/stages/settle.hpp"
#include "jamscape/protocol/stages/steps.hpp"

/// STAGE(name in study files, its struct)
#define JAM_STAGES(STAGE)   \
  STAGE(compress, Compress) \
  STAGE(steps, Steps)       \
  STAGE(relax, Relax)       \
  STAGE(settle, Settle)     \
  STAGE(press, Press)
