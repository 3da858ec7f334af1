// What Orris accepts at most of the texts that it expands, reads or lists. How many bytes a file may have that is read
// whole stands where it is read (files/read_file.h, PackLimits, world/world.cpp). Packs and worlds are written by
// strangers: each of these numbers bounds time or memory, lies far above what published packs need, and is met with a
// located message. docs/limits.md gives the reason for each; tests/core/limits_test.cpp compares the two.
#pragma once

#include <cstddef>

namespace orris::limits {

// Messages (core/message_limits.h).
constexpr std::size_t kMessagesOfAKind = 10'000;
constexpr std::size_t kMessageListBytes = std::size_t{32} << 20;
constexpr std::size_t kQuotedLineBytes = 16'384;
constexpr std::size_t kMessageBytes = 4'096;
constexpr std::size_t kMessageNotes = 32;
constexpr std::size_t kMessageIncludes = 32;
constexpr std::size_t kPrintedOfAKind = 100;

// Folders of a pack (core/files/file_source.h, whose PackLimits has bytes and files).
constexpr std::size_t kPackFolders = 4'096;
// core/files/snapshot_source.h
constexpr std::size_t kSnapshotBytes = std::size_t{64} << 20;

// Text files of a pack (core/files/text_file.h).
constexpr std::size_t kTextFileBytes = std::size_t{4} << 20;
constexpr std::size_t kTextFileLines = 100'000;
constexpr std::size_t kPropertyLines = 20'000;
constexpr std::size_t kPropertyWords = 200'000;
constexpr std::size_t kPackTextBytes = std::size_t{32} << 20;

// One stage of a program: its files in place of their includes, then preprocessed (glsl/).
constexpr std::size_t kIncludeDepth = 256;
constexpr std::size_t kStageFiles = 50'000;
constexpr std::size_t kStageLines = 2'000'000;
constexpr std::size_t kStageBytes = std::size_t{256} << 20;
constexpr std::size_t kStageReadBytes = std::size_t{16} << 20;
constexpr std::size_t kStageTokens = 400'000;
constexpr std::size_t kStructMembers = 65'536;
constexpr std::size_t kInlinedTokens = 1'000'000;
constexpr std::size_t kArrayElements = 8'192;
constexpr std::size_t kSwitchCases = 1'000;
constexpr std::size_t kExpandedTokens = 400'000;
constexpr std::size_t kExpandedBytes = std::size_t{32} << 20;
constexpr std::size_t kTokenBytes = 65'536;
constexpr std::size_t kMacroArgumentDepth = 64;
constexpr std::size_t kMacroContexts = 4'096;

// Options and *.properties files (pack/).
constexpr std::size_t kProfiles = 1'000;
constexpr std::size_t kProfileWords = 20'000;
constexpr std::size_t kProfileDepth = 64;
constexpr std::size_t kScreenKeys = 2'000;
constexpr std::size_t kCustomUniforms = 2'000;
constexpr std::size_t kTextureKeys = 1'000;
constexpr std::size_t kDimensionFolders = 64;
constexpr std::size_t kOptions = 5'000;
constexpr std::size_t kOptionValues = 2'000;
constexpr std::size_t kSuggestions = 200;
constexpr std::size_t kStageErrors = 100;

// Worlds (world/).
constexpr std::size_t kWorldJsonBytes = std::size_t{16} << 20;
constexpr std::size_t kWorldJsonValues = 500'000;
constexpr std::size_t kWorldJsonDepth = 32;
constexpr std::size_t kWorldErrors = 100;
constexpr std::size_t kWorldBlocks = std::size_t{1} << 25;
constexpr std::size_t kWorldWork = std::size_t{1} << 27;
constexpr std::size_t kWorldCameras = 1'000;
constexpr std::size_t kWorldThings = 1'000;
constexpr std::size_t kWorldTextGlyphs = 64;
constexpr std::size_t kSchematicBytes = std::size_t{64} << 20;
constexpr std::size_t kSaveRadius = 32;
constexpr std::size_t kSaveRegions = 65'536;
constexpr std::size_t kRegionBytes = std::size_t{256} << 20;
constexpr std::size_t kChunkBytes = std::size_t{16} << 20;
constexpr std::size_t kSaveBytes = std::size_t{1} << 30;
constexpr std::size_t kMapBlockBytes = std::size_t{4} << 20;
constexpr std::size_t kMapPlaces = std::size_t{1} << 20;
constexpr std::size_t kMapSteps = std::size_t{1} << 26;
constexpr std::size_t kMapMemory = std::size_t{256} << 20;

// Resource packs (world/resources, core/files/asset_source.h).
constexpr std::size_t kResourceJsonBytes = std::size_t{4} << 20;
constexpr std::size_t kModelDepth = 64;
constexpr std::size_t kModelElements = 4'096;
constexpr std::size_t kModelTextures = 1'024;
constexpr std::size_t kStateVariants = 4'096;
constexpr std::size_t kModelFaces = 1'000'000;
constexpr std::size_t kModelMeshFaces = 4'000'000;
constexpr std::size_t kItemFaces = 200'000;
constexpr std::size_t kTextureTexels = std::size_t{1} << 24;
constexpr std::size_t kAtlasTexels = std::size_t{1} << 26;

}  // namespace orris::limits
