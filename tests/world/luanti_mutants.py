"""Mistakes put into the reader of Luanti worlds, and the tests of test_world that must find them.

For tests/stability/host_kill_list.py --table, by file: name, tests, what is replaced by what.
"""

MUTANTS = {
    "loader/world/luanti/map_block.cpp": [
        ("format: 30 is read", "MapBlocks.*", "kNewestFormat = 29", "kNewestFormat = 30"),
        ("format: wide numbers come later", "LuantiWorlds.*", "kWideContent = 24", "kWideContent = 25"),
        ("format: timers stand in front", "LuantiWorlds.*", "kTimersBehind = 25", "kTimersBehind = 24"),
        ("format: light comes later", "LuantiWorlds.*", "kLightComplete = 27", "kLightComplete = 28"),
        ("nodes: long numbers lose their end", "LuantiWorlds.*", "id << 4 | std::uint8_t(block.param2[i]) >> 4", "id << 4"),
        ("nodes: param2 is param1", "MapBlocks.*", "kSectionBlocks * (wide + 1), kSectionBlocks", "kSectionBlocks * wide, kSectionBlocks"),
        ("names: numbers without one", "MapBlocks.*", "id >= indexOfId.size() || indexOfId[id] == 0", "id >= indexOfId.size()"),
        ("names: an end inside", "MapBlocks.*", 'return !reader.ended() || fail("it ends inside its list of names");', "return true;"),
        ("bombs: metadata of any size", "MapBlocks.*", "limits::kChunkBytes, metadata", "limits::kSaveBytes, metadata"),
        ("bombs: a frame of any size", "MapBlocks.*", "limits::kChunkBytes, body", "limits::kSaveBytes, body"),
        ("bombs: sizes are not counted", "MapBlocks.*", "size += bytes.size();", ""),
        ("objects: only one is skipped", "LuantiWorlds.*", "i < count && !reader.ended(); ++i) {\n      reader.text(kObjectBytes)",
         "i < 1 && i < count && !reader.ended(); ++i) {\n      reader.text(kObjectBytes)"),
    ],
    "loader/world/files/unzstd.cpp": [
        ("zstd: windows of any size", "MapBlocks.*", "kWindowBits = 24", "kWindowBits = 27"),
        ("zstd: a cut frame is whole", "LuantiWorlds.*", "return GunzipResult::Truncated;", "return GunzipResult::Ok;"),
    ],
    "loader/world/luanti/map_database.cpp": [
        ("map: no bound of steps", "LuantiWorlds.*", "budget.steps == 0 || full", "full"),
        ("map: virtual tables are read", "LuantiWorlds.*", " || sqlite3_column_int64(table.get(), 0) <= 0", ""),
        ("map: computed columns are read", "LuantiWorlds.*", "sqlite3_column_int(columns.get(), 6) != 0", "false"),
        ("map: blobs of any size", "LuantiWorlds.*", "{SQLITE_LIMIT_LENGTH, int(limits::kMapBlockBytes)}, ", ""),
        ("map: places beside the part", "LuantiWorlds.*", "beside = place.x < lowX || place.x > highX;", ""),
        ("map: a height is jumped over", "LuantiWorlds.*", "place.x < lowX ? place.y : place.y + 1", "place.y + 1"),
    ],
    "loader/world/luanti/luanti_columns.cpp": [
        ("mirror: nodes run north", "LuantiWorlds.*", "z = 15 - (i >> 8)", "z = i >> 8"),
        ("mirror: map blocks run north", "LuantiWorlds.*", "mirroredZ(at.first)}", "at.first}"),
        ("order: y and z exchanged", "LuantiWorlds.*", "y << 8 | z << 4 | x;", "z << 8 | y << 4 | x;"),
        ("heights: from below", "LuantiWorlds.*", "const bool atSea = first != heights.end()", "const bool atSea = first == heights.end()"),
        ("doors: no upper half", "LuantiWorlds.*", 'door.properties["half"] = "upper";', ""),
        ("doors: across map blocks none", "LuantiWorlds.*", "lowest ? y - 1 : y", "y"),
        ("unknown: not counted", "LuantiWorlds.*", "losses.unknownNodes += count;", ""),
        ("unknown: names as they are", "LuantiWorlds.*", "printable(block_.names[node].substr(0, kNameShown))",
         "block_.names[node].substr(0, kNameShown)"),
    ],
    "loader/world/luanti/luanti_files.cpp": [
        ("time: midnight is sunrise", "LuantiWorlds.*", "*time % kTicksOfDay + kTicksOfDay - kSixInTheMorning", "*time"),
    ],
    "loader/world/luanti/luanti_world.cpp": [
        ("joins: fences stand alone", "LuantiWorlds.*", "  joinSides(*blocks);\n", ""),
        ("files: links lead out", "LuantiWorlds.*", "if (!liesBelow(files.folder.string(), files.map.string()))", "if (false)"),
        ("place: always the middle", "LuantiWorlds.*", "&& !atMiddle.empty()", "&& false"),
        ("cameras: on the other side", "LuantiWorlds.*", "{place->x, mirroredZ(place->y)}", "{place->x, place->y}"),
    ],
    "loader/world/luanti/node_blocks.cpp": [
        ("stairs: upper ones turn as lower ones", "NodeBlocks.*", "0, 5, 2, 4, 0, 3, 2, 1}", "0, 5, 2, 4, 0, 1, 2, 3}"),
        ("stairs: left stays left", "NodeBlocks.*", "if (top && shape", "if (false && shape"),
        ("slabs: all below", "NodeBlocks.*", '? "top" : "bottom";\n      break;\n    case NodeTurn::Level', '? "bottom" : "bottom";\n      break;\n    case NodeTurn::Level'),
        ("walls: towards the wall", "NodeBlocks.*", '"north", "north", "west", "east",', '"north", "north", "east", "west",'),
        ("fronts: are backs", "NodeBlocks.*", "(side + 2) % 4", "side"),
        ("liquids: upside down", "NodeBlocks.*", "std::clamp(8 - height, 1, 7)", "std::clamp(height, 1, 7)"),
        ("logs: x and z exchanged", "NodeBlocks.*", '{"y", "z", "z", "x", "x", "y"}', '{"y", "x", "x", "z", "z", "y"}'),
    ],
}
