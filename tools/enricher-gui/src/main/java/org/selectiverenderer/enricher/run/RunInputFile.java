package org.selectiverenderer.enricher.run;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.AxisAngle4d;
import org.joml.Vector3dc;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.browser.viewer.Pose;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.TextEdit;
import org.selectiverenderer.x3d.source.XmlParseException;

/**
 * The input file of a run.
 *
 * @param file the scene's own file, or a temporary copy
 * @param copy whether it is a copy, to be deleted after the run
 * @param viewpoint DEF name of the viewpoint to begin at; empty for the scene's own
 */
record RunInputFile(Path file, boolean copy, Optional<String> viewpoint) {
  private static final String VIEWPOINT = "Enricher_Here";
  private static final int DECIMALS = 6;

  /**
   * Returns the input file for the present state of a scene. A copy, if needed, is written beside
   * the scene's file, since the scene's relative urls would not resolve elsewhere.
   *
   * @param saved whether the file has exactly this text
   * @param here the pose to begin at; empty for the start viewpoint
   * @throws IOException with one line, if the text is not well formed or cannot be written
   */
  static RunInputFile of(Path file, DocumentSnapshot snapshot, boolean saved, Optional<Pose> here)
      throws IOException {
    if (saved && here.isEmpty()) {
      return new RunInputFile(file, false, Optional.empty());
    }
    Edit edit = new Edit(VIEWPOINT, here.map(pose -> viewpoint(snapshot, pose)).orElse(List.of()));
    Path folder = file.toAbsolutePath().getParent();
    String name = file.getFileName().toString();
    int dot = Math.max(0, name.indexOf('.'));
    try {
      Path copy =
          Files.createTempFile(folder, "." + name.substring(0, dot) + "-run-", name.substring(dot));
      copy.toFile().deleteOnExit(); // In case the window ends before the run.
      Files.write(copy, snapshot.bytes(edit));
      return new RunInputFile(
          copy, true, edit.isEmpty() ? Optional.empty() : Optional.of(VIEWPOINT));
    } catch (IOException e) {
      throw new IOException(Texts.of("run.nocopy", folder.toString(), e.toString()), e);
    }
  }

  /**
   * Returns the insertion of a Viewpoint as the first child of the Scene; none for an empty Scene.
   */
  private static List<TextEdit> viewpoint(DocumentSnapshot snapshot, Pose pose) {
    List<TextEdit> changes = new ArrayList<>();
    try {
      snapshot
          .elements()
          .scene()
          .filter(scene -> !scene.children().isEmpty())
          .ifPresent(
              scene -> {
                int at = scene.children().get(0).start();
                changes.add(new TextEdit(at, at, written(pose)));
              });
    } catch (XmlParseException e) {
      return List.of(); // The run reports the fault.
    }
    return changes;
  }

  private static String written(Pose pose) {
    AxisAngle4d turn = new AxisAngle4d(pose.orientation());
    Vector3dc at = pose.position();
    return ("<Viewpoint DEF='%s' description='%s' position='%s' orientation='%s'"
            + " fieldOfView='%s'/>")
        .formatted(
            VIEWPOINT,
            VIEWPOINT,
            numbers(at.x(), at.y(), at.z()),
            numbers(turn.x, turn.y, turn.z, turn.angle),
            numbers(pose.fieldOfView()));
  }

  private static String numbers(double... numbers) {
    StringBuilder text = new StringBuilder();
    for (double number : numbers) {
      text.append(text.isEmpty() ? "" : " ").append(DecimalFormatter.rounded(number, DECIMALS));
    }
    return text.toString();
  }

  /** Returns the arguments of the run command. */
  List<String> words(RunOptions choice) {
    List<String> words = new ArrayList<>(List.of("run", file.toString()));
    words.addAll(List.of("--condition", choice.condition()));
    viewpoint.ifPresent(name -> words.addAll(List.of("--viewpoint", name)));
    return words;
  }

  /** Deletes the file if it is a copy. */
  void clear() throws IOException {
    if (copy) {
      Files.deleteIfExists(file);
    }
  }
}
