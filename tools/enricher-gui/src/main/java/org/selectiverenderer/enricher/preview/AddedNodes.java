package org.selectiverenderer.enricher.preview;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.scene.Scene;

/**
 * The new children that a {@link ScenePatch} gives to groups, with the files that they name. They
 * are read apart from applying the patch, since files may be long in coming.
 *
 * @param scenes a scene for each change of children, in order; empty for one that cannot be read
 */
record AddedNodes(List<Optional<Scene>> scenes) {
  private static final String NAME = "children";

  /** Copies the list. */
  AddedNodes {
    scenes = List.copyOf(scenes);
  }

  /**
   * Reads the new children of a patch. For a thread that may wait for files.
   *
   * @param loaded the scene that the patch is for, whose loader reads them
   */
  static AddedNodes of(ScenePatch patch, LoadedPreview loaded) {
    return new AddedNodes(
        patch.children().stream().map(children -> read(children, loaded)).toList());
  }

  private static Optional<Scene> read(ScenePatch.Children children, LoadedPreview loaded) {
    // Materials and textures mean other things in X3D 3 than in X3D 4 (X3D 4.0, 12.2.4).
    String version = loaded.world().scene().version().startsWith("4") ? "4.0" : "3.3";
    String text =
        "<X3D profile='Full' version='%s'><Scene>".formatted(version)
            + children.added()
            + "</Scene></X3D>";
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    ProblemCollector problems = new ProblemCollector(); // The document's own checks report them.
    try {
      Scene read =
          loaded
              .loader()
              .load(NAME, new ByteArrayInputStream(bytes), loaded.folder(), problems)
              .scene();
      return Optional.of(read)
          .filter(scene -> scene.root().nodes("children").size() == children.count());
    } catch (IOException e) {
      return Optional.empty();
    }
  }
}
