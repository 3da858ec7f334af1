// Packs, files and this machine.
#include <vector>

#include "check/rules/rule_tables.h"

namespace orris {

std::span<const Rule> hostRules() {
  static const std::vector<Rule> kRules = {
      {"camera-unknown", Severity::Error, "--camera names no camera of the world", kUsage},
      {"checkpoint-read", Severity::Error,
       "a checkpoint of trace is damaged or belongs to another picture"},
      {"checkpoint-write", Severity::Error, "a checkpoint of trace cannot be written"},
      {"chunks-left-out", Severity::Warning, "chunks of a save are not drawn"},
      {"compare-size", Severity::Error, "two pictures of different sizes cannot be compared"},
      {"config-refused", Severity::Error,
       "orris.toml of the working folder names what only --config may name", kUsage},
      {"dimension-unknown", Severity::Error, "--dimension names no dimension", kUsage},
      {"driver-emulation", Severity::Note,
       "what this driver lacks for a program is done with other code"},
      {"dump-unknown", Severity::Error, "--dump names no buffer of the frame"},
      {"export-format", Severity::Error,
       "no format of `orris world --export` has this file ending"},
      {"export-size", Severity::Error, "a world has more faces than a glTF file can hold"},
      {"file-unreadable", Severity::Error, "a file named on the command line cannot be read", kUsage},
      {"file-unwritable", Severity::Error, "an output file cannot be written", kUsage},
      {"gl-context-refused", Severity::Error,
       "the driver gives no context of the profile asked for that is new enough"},
      {"gl-error", Severity::Error, "the driver reported an error while a frame was drawn"},
      {"gl-function-missing", Severity::Error,
       "the driver does not offer a function of its own version"},
      {"gl-library-missing", Severity::Error, "OSMesa or EGL is not installed"},
      {"gl-no-headless-context", Severity::Error, "neither OSMesa nor EGL gives a context"},
      {"gl-no-window", Severity::Error, "no window can be opened"},
      {"gl-too-old", Severity::Error, "the driver lacks a version or an extension that is needed"},
      {"graph-format-unknown", Severity::Error, "no form of the pass graph has this file ending"},
      {"graphviz-failed", Severity::Error, "Graphviz did not draw the pass graph"},
      {"graphviz-missing", Severity::Error, "Graphviz is not installed"},
      {"image-codecs", Severity::Error, "the picture codecs of Orris cannot be loaded"},
      {"image-decode", Severity::Error, "a picture file is damaged"},
      {"image-read", Severity::Error, "a picture cannot be opened"},
      {"image-write", Severity::Error, "a picture cannot be written"},
      {"level-unreadable", Severity::Warning, "the level.dat of a save is damaged"},
      {"limit-exceeded", Severity::Error, "a comparison passes a limit given on the command line"},
      {"messages-left-out", Severity::Warning,
       "more messages of one kind than are kept, or more text than they may hold"},
      {"no-programs", Severity::Error, "no file of the pack is a program that the host knows"},
      {"not-finite", Severity::Error, "a pass writes NaN or Inf"},
      {"options-unsaved", Severity::Warning, "options chosen in the window cannot be saved"},
      {"pack-counter", Severity::Warning, "a pack counts what a user should know of"},
      {"pack-too-large", Severity::Error, "the pack has more bytes or files than a pack may have", kUsage},
      {"pack-unreadable", Severity::Error, "what was named holds no shader pack", kUsage},
      {"picture-format-unknown", Severity::Error, "no picture format has this file ending", kUsage},
      {"program-left-out", Severity::Error,
       "the picture lacks what programs draw that this driver cannot run"},
      {"schematic-invalid", Severity::Error,
       "a schematic, litematic or structure does not hold what its format asks for", kUsage},
      {"script-failed", Severity::Error, "a step of a script of the window failed"},
      {"script-step", Severity::Error, "a script of the window has a step that there is not"},
      {"shard-mismatch", Severity::Error, "the shards of --merge are not of one picture"},
      {"shard-missing", Severity::Error, "--merge lacks a shard of the picture"},
      {"show-unknown", Severity::Error, "--show names nothing that the frame holds"},
      {"symlink-outside", Severity::Warning, "a symbolic link leads nowhere or out of the pack"},
      {"unknown-block", Severity::Warning, "the world has a block that this host does not know"},
      {"world-json-syntax", Severity::Error, "world.json is no JSON", kUsage},
      {"world-json-value", Severity::Error,
       "a value of world.json is missing, unknown or out of range", kUsage},
      {"world-unreadable", Severity::Error, "a world cannot be opened", kUsage},
      {"zip-unreadable", Severity::Error, "the zip is damaged, or a file in it is too large", kUsage},
  };
  return kRules;
}

}  // namespace orris
