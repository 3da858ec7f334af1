"""Mistakes put into the command `orris`, and the cases of the scripts that must find them.

For script_kill_list.py, by file: name, cases ("apart:pause ...": of apart_test.py those whose names begin so), what is
replaced by what.
"""

MUTANTS = {
    "loader/app/view/viewer_processes.cpp": [
        ("going on: never", "apart:edit_that apart:option_that apart:edit_while",
         "if (draws || !kept_->canGoOn()) return status;", "return status;"),
        ("going on: with a pack that dies itself", "apart:edit_that", "    death_ = report_.all().back();\n", ""),
        ("sandbox: reads what lies beside hidden folders", "apart:what_lies",
         'return entry.path().filename().string().starts_with(".");', "return false;"),
        ("sandbox: reads no folder that is made anew", "apart:folder_that", "    addReadPlace(pack.path);\n", ";"),
        ("sandbox: reads no file put in the place of another", "apart:files_that",
         "files.inputs = {optionFile, options_.pack.path};", "files.inputs = {};"),
    ],
    "loader/app/view/apart/kept_pack.cpp": [
        ("going on: with files that are new", "apart:edit_that", ": files_(state.files), texts_", ": files_(below->files()), texts_"),
        ("going on: with texts as they are now", "apart:edit_that",
         "if (found != texts_.end()) return found->second;", "if (found == texts_.end()) return std::nullopt;"),
        ("going on: with the pack that died", "apart:window_ends", "shared_ && shared_->risk && ", "shared_ && "),
    ],
    "loader/app/view/pack/live_pack.cpp": [
        ("going on: with options of the start", "apart:option_that",
         "  if (kept) load->fileValues = kept->values;\n", ""),
        ("options: not saved", "apart:options_are", "  if (*succeeded && attempt.saves) save();\n", ""),
    ],
    "loader/app/view/viewer.cpp": [
        ("going on: where the camera was at the start", "apart:edit_that", "  session.setCamera(scene.camera);\n", ""),
        ("going on: at the time of the start", "apart:time_of", "  session.environment().time = scene.time;\n", ""),
        ("going on: without its panels", "apart:time_of", "((scene.panels >> i) & 1) != 0;", "false;"),
        ("going on: edits meanwhile are lost", "apart:edit_while", "  if (changed) pack_->reload(", "  if (!changed) pack_->reload("),
    ],
    "loader/app/view/apart/remote_surface.cpp": [
        ("panel: no click comes", "apart:options_are",
         "      events.push_back(news.event);\n",
         "      if (news.event.kind != ViewEvent::Kind::Button) events.push_back(news.event);\n"),
        ("editor: opened nowhere", "apart:editor",
         "  sendOrder(link_.drawingEnd(), {WindowOrder::Kind::Edit, at.line, 0, at.file});\n", ""),
    ],
    "loader/app/view/apart/shown_window.cpp": [
        ("editor: at the first line", "apart:editor", ".line = order.first}", ".line = 1}"),
        ("editor: opened for nobody", "apart:editor", "    mayEdit_ |= event.pressed;\n", ""),
    ],
    "loader/app/drawing/supervised_run.cpp": [
        ("limits: a frame without end", "apart:driver_that", "return spent_ > limit_;", "return false;"),
        ("limits: a pause counts", "apart:pause", "if (note.idle || note.pieces", "if (note.pieces"),
        ("limits: a death without a word", "apart:driver_that",
         "  report.add(diagnostics);\n  return kHostFailed;", "  return kHostFailed;"),
        ("sandbox: files stay open", "apart:process_that", "  closeOpenFiles(std::move(keep));\n", ""),
        ("sandbox: none", "apart:process_that", "  enterSandbox(readPlaces(), cache);\n", ""),
    ],
    "loader/app/lsp/overlay_source.cpp": [
        ("lsp: checks what is on the disk", "lsp:findings_come lsp:random_edits",
         "return found == overlay_.end() ? below_->read(path) : found->second;", "return below_->read(path);"),
    ],
    "loader/app/lsp/check_work.cpp": [
        ("lsp: no first news", "lsp:errors_of", "if (!stages.empty())", "if (stages.size() > 1000)"),
        ("lsp: findings of the first programs are lost", "lsp:errors_of",
         "  checker.glslang = verdictsOf(memory.quiet);\n  PackVerdict", "  PackVerdict"),
        ("lsp: notes are findings", "lsp:findings_come lsp:random_edits",
         "finding.silence == Silence::None && finding.diagnostic.severity != Severity::Note", "finding.silence == Silence::None"),
    ],
    "loader/app/lsp/check_service.cpp": [
        ("lsp: a lost check is not reported", "lsp:a_check_that",
         'toSay_ += lineOf({{"part", "lost"}, {"job", job}});', "static_cast<void>(job);"),
    ],
    "loader/app/lsp/hover.cpp": [
        ("lsp: where a value was set is left out", "lsp:names_are_explained", "known.valuesFrom)", '"")'),
    ],
    "loader/app/lsp/definitions.cpp": [
        ("lsp: what is declared lies a line late", "lsp:definitions", "const int line = name.origin.line - 1;",
         "const int line = name.origin.line;"),
        ("lsp: keys lie a line late", "lsp:definitions", "symbolJson(key, kKey, int(i),", "symbolJson(key, kKey, int(i) + 1,"),
    ],
    "loader/app/lsp/background_check.cpp": [
        ("lsp: killed processes stay away", "lsp:processes_that",
         '{{"part", "lost"}});\n  stop();', '{{"part", "lost"}});'),
        ("lsp: processes hold each other", "lsp:no_process", "    closeAllBut(jobs[0], out[1]);\n", ""),
    ],
    "loader/app/lsp/edited_pack.cpp": [
        ("lsp: closing a file changes nothing", "lsp:findings_come",
         "if (overlay_.erase(packPath) > 0) changedOnDisk(packPath);", "overlay_.erase(packPath);"),
        ("lsp: definitions of the last saved file", "lsp:definitions", "  if (knowledge_ && !stale_) return *knowledge_;",
         "  if (knowledge_) return *knowledge_;"),
    ],
    "loader/app/lsp/completion.cpp": [
        ("lsp: no options are completed", "lsp:names_are_completed",
         '    items.add(name, kConstantItem, fmt::format("option, {}", pack.options.value(pack.values, name)));\n', ";"),
    ],
    "loader/app/lsp/published.cpp": [
        ("lsp: the other errors of a program go", "lsp:errors_of",
         "    if (!concerns(finding)) kept.push_back(std::move(finding));\n", "    kept.push_back(std::move(finding));\n"),
    ],
    "loader/app/lsp/server.cpp": [
        ("lsp: columns are always UTF-16", "lsp:columns",
         'utf8_ = std::ranges::find(encodings, json("utf-8")) != encodings.end();', "utf8_ = encodings.is_null();"),
        ("lsp: nonsense is no error", "lsp:nonsense", "  if (!known) {", "  if (!known && id.is_null()) {"),
    ],
    "loader/pack/programs/program_reuse.cpp": [
        ("lsp: programs that an edit reaches are not built again", "lsp:findings_come lsp:random_edits",
         " && !reachesEdit(entry) &&", " &&"),
    ],
}
