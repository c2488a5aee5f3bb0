package org.selectiverenderer.app.rehearsal;

import java.io.IOException;
import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.walkthrough.Walkthrough;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/** Loads the scene of a view as a session does, and puts the viewer at its viewpoint. */
final class SceneViewer {
  private SceneViewer() {}

  /**
   * Opens a view.
   *
   * @param access further folders and hosts that the scene may refer to
   * @param problem receives the problems of the scene, and a viewpoint or Switch that is not there
   * @throws IOException if the scene cannot be read, with a message of one line
   */
  static Walkthrough open(
      StudyView view, long seed, ContentAccessPolicy access, Consumer<Problem> problem)
      throws IOException {
    Walkthrough walk =
        Walkthrough.open(
            view.scene(),
            new SelectiveController.Settings(view.condition(), seed).with(view.qualities()),
            access,
            problem,
            event -> {},
            text -> {});
    Optional<Node> viewpoint =
        walk.world().views().viewpoints().stream()
            .filter(node -> view.viewpoint().equals(node.name()))
            .findFirst();
    viewpoint.ifPresent(walk.world().views()::goTo);
    walk.step(0, (viewer, time, dt) -> {});
    view.choices().forEach((name, choice) -> choose(walk, name, choice));
    walk.step(0, (viewer, time, dt) -> {});
    return walk;
  }

  private static void choose(Walkthrough walk, String name, int choice) {
    walk.world()
        .scene()
        .find(name)
        .ifPresent(
            node ->
                node.type()
                    .field("whichChoice")
                    .ifPresent(field -> node.emit(field.index(), choice, walk.world().cascade())));
  }
}
