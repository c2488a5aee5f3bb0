package org.selectiverenderer.app.session;

import java.util.Optional;
import java.util.function.Consumer;
import org.joml.Quaterniond;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.viewer.ViewerMotion;
import org.selectiverenderer.study.definition.MovementConstraint;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.walkthrough.Walkthrough;

/**
 * The motion of a participant during a session: by the participant's own controls, or turning round
 * where a participant is simulated, confined as the study asks.
 */
final class ParticipantMotion {
  /** The angular speed of a simulated participant in radians per second: one turn in 20 s. */
  private static final double TURN = 2 * Math.PI / 20;

  private final Session session;
  private final Consumer<Problem> problem;

  /**
   * @param problem receives a warning when the participant cannot be confined as the study asks
   */
  ParticipantMotion(Session session, Consumer<Problem> problem) {
    this.session = session;
    this.problem = problem;
  }

  /** Returns the motion without bounds. */
  ViewerMotion free(ViewerMotion users) {
    return session.options().unattended()
        ? (viewer, time, dt) ->
            viewer.turnTo(new Quaterniond().rotationY(TURN * dt).mul(viewer.orientation()))
        : users;
  }

  /** Returns the motion within the bounds of an area. */
  ViewerMotion within(Walkthrough scene, Study.Area area, ViewerMotion users) {
    return within(
        scene, session.material().study().stay(area), area.within(), "area " + area.name(), users);
  }

  /**
   * Returns the motion within bounds.
   *
   * @param within DEF of the ProximitySensor or the room; empty for the room around the viewpoint
   * @param where what is bounded, for messages
   */
  ViewerMotion within(
      Walkthrough scene,
      MovementConstraint stay,
      Optional<String> within,
      String where,
      ViewerMotion users) {
    ViewerMotion moving = free(users);
    if (stay == MovementConstraint.TURN) {
      return MovementBounds.standing(scene.world().viewer(), moving);
    }
    MovementBounds enclosure = MovementBounds.open(scene);
    if (stay == MovementConstraint.WALK
        && !within.map(enclosure::add).orElseGet(enclosure::addRoom)) {
      tell(
          where,
          within
                  .map(name -> "the viewpoint is not in " + name + ", a ProximitySensor or room")
                  .orElse("the viewpoint is in no room")
              + "; the participant can walk out of the area");
    }
    if (session.material().study().course().closed() && !enclosure.addRoom()) {
      tell(where, "the viewpoint is in no room, so the room cannot be closed");
    }
    return enclosure.around(moving);
  }

  private void tell(String where, String what) {
    problem.accept(
        new Problem(
            Problem.Severity.WARNING,
            SourceLocation.of(session.material().study().file().toString()),
            where + ": " + what));
  }
}
