// A change of the pack in parts, between which a session draws frames.
#include <chrono>
#include <iterator>
#include <limits>
#include <utility>

#include <orris/render/session/render_session.h>

namespace orris {
namespace {

void appendTo(Diagnostics& all, Diagnostics more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

void RenderSession::begin(const std::string& cause, PackLoader load) {
  change_ = std::make_unique<Change>();
  change_->cause = cause;
  change_->load.emplace(request_.load, std::move(load), auto_, renderer_->sharedPack());
}

std::optional<bool> RenderSession::advance(double seconds, Diagnostics& diagnostics) {
  if (ended_) return std::exchange(ended_, std::nullopt);
  if (!change_) return std::nullopt;
  using Clock = std::chrono::steady_clock;
  if (!change_->pack) {
    // A frame drawn meanwhile would take the processors that the load needs, and come before what it brings.
    if (!change_->load->readyWithin(seconds)) return std::nullopt;
    if (!takeLoaded()) return endChange(false, diagnostics);
    if (!change_->pack) return std::nullopt;
  }
  const Clock::time_point began = Clock::now();
  while (renderer_->buildAhead(change_->pack, scene_, change_->report, change_->problems))
    if (std::chrono::duration<double>(Clock::now() - began).count() >= seconds) return std::nullopt;
  return endChange(!hasErrors(change_->problems), diagnostics);
}

std::optional<bool> RenderSession::finish(Diagnostics& diagnostics) {
  while (change_) {
    if (!change_->pack) change_->load->wait();
    const auto end = advance(std::numeric_limits<double>::infinity(), diagnostics);
    if (end) return end;
  }
  return std::exchange(ended_, std::nullopt);
}

void RenderSession::waitForChange(Diagnostics& diagnostics) {
  if (change_) ended_ = finish(diagnostics);
}

/// What the thread made. false: errors.
bool RenderSession::takeLoaded() {
  Change& change = *change_;
  BackgroundLoad::Result result = change.load->take();
  appendTo(change.problems, std::move(result.problems));
  if (!result.pack) return false;
  if (change.asked) {
    change.pack = std::move(result.pack);
    return true;
  }
  change.asked = std::move(result.pack);
  change.request = std::move(result.request);
  change.choices = auto_;
  change.choices.choose(*change.asked, change.request, meterFor(*change.asked));
  if (change.choices.all().empty()) {
    change.pack = change.asked;
  } else if (result.settled && change.choices.text() == auto_.text()) {
    change.pack = std::move(result.settled);
    appendTo(change.problems, std::move(result.settledProblems));
  } else {
    loadSettled();
  }
  return true;
}

/// AUTO has become another value than it had.
void RenderSession::loadSettled() {
  const auto again = [asked = change_->asked](LoadRequest& request, Diagnostics& diagnostics) {
    auto pack = rebuildShaderPack(*asked, request, diagnostics);
    return pack ? std::make_shared<const ShaderPack>(std::move(*pack)) : nullptr;
  };
  change_->load.emplace(change_->choices.applied(change_->request), again, AutoChoices(), nullptr);
}

bool RenderSession::endChange(bool good, Diagnostics& diagnostics) {
  const auto change = std::exchange(change_, nullptr);
  appendTo(diagnostics, std::move(change->problems));
  const auto askedBefore = asked_;
  const AutoChoices choicesBefore = auto_;
  if (good) {
    asked_ = change->asked;
    auto_ = change->choices;
    chosenFor_ = {frame_, scene_.world.environment.time, request_.camera.position, false};
  }
  const bool taken = take(change->cause, good ? change->pack : nullptr, diagnostics, std::move(change->report));
  renderer_->forgetAhead();
  if (taken) {
    request_.load = change->request;
  } else {
    asked_ = askedBefore;
    auto_ = choicesBefore;
  }
  return taken;
}

}  // namespace orris
