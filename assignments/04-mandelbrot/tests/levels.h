// The level sets of I(c), section 4.4, and whether a student's picture shows them. The colours are
// the student's choice: only which pixels look the same and which look different is judged.
#pragma once

#include <subject/Judge.h>

#include <optional>
#include <vector>

#include "../views.h"

namespace levels {

using course::View;

inline constexpr int kSide = 120;            ///< of the judged pictures, in pixels
inline constexpr double kOutliers = 0.0025;  ///< share of pixels that rounding may move

/// I(c) of the notes: the loop's index at the escape, 0 when there is none within maxiter steps.
int index(const glm::vec2& c, int maxiter);

/// The point of a pixel, eq. (4.3); row 0 is at the top.
glm::vec2 pointOf(const View& view, int column, int row);

/// Whether rounding, however a program does it, leaves the level of c as it is.
bool isFirm(const glm::vec2& c, int maxiter, float zoom = 1.0f);

/// "center (0, 0), zoom 2, maxiter 50"
std::string tell(const View& view);

/// Keeps for the evidence what every palette shows alike: where colours change between pixels some
/// way apart. `pictures`: one or more below each other, kSide wide.
void observeEdges(const std::vector<glm::vec3>& pictures);

/// What is wrong with a picture, which pixels or levels; empty when each level set has one colour
/// and neighbouring ones have two. Inside and first step escapes, both of I = 0, may be one colour
/// or two.
std::string complaint(const View& view, const std::vector<glm::vec3>& picture);

/// Whether two pictures are the same, but for the pixels that rounding may move.
bool areAlike(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b);

/// The picture that the student's shader draws when the course sets the uniforms.
std::vector<glm::vec3> pictureOf(const View& view);

/// Fails when there is a complaint about that picture.
bool expectPicture(const View& view);

/// Fails unless the level sets are right for maxiter = first, and when an escape in the last step
/// looks like the inside for maxiter = first and the two after it. A palette that repeats may give
/// both one colour once, not three times.
bool expectLastStepSeen(const glm::vec2& center, float zoom, int first);

/// Fails unless I of every point is right: by values where the shader has a function
/// `int iterate(vec2)`, else by the pictures of `instead`. `which` begins the sentence of what is
/// wrong.
void expectIndices(const std::vector<glm::vec2>& points, int maxiter, const View& instead,
                   const std::string& which = "");

/// Values of a function of the student's shader; nothing when it has no such function, or one that
/// is called another way: then pictures have to tell.
template <class R, class... A>
std::optional<R> valuesOf(const std::string& function, const A&... arguments) {
    judge::Subject& subject = judge::subject();
    const protocol::Answer answer = subject.tryShade(function, arguments...);
    if (answer.outcome != protocol::Outcome::ok)
        return std::nullopt;
    subject.onTodos(answer.todos);
    return protocol::decode<R>(protocol::decodeDrawAnswer(answer.payload).value);
}

}  // namespace levels
