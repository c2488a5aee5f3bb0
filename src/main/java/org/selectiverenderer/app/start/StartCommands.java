package org.selectiverenderer.app.start;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.app.process.ProgramCommand;

/** The commands that the start window starts. */
public final class StartCommands {
  private StartCommands() {}

  /** Shows a scene. */
  public static ProgramCommand show(Path scene) {
    return new ProgramCommand(List.of("run", scene.toString()));
  }

  /** Opens the enricher. */
  public static ProgramCommand enrich(Optional<Path> scene) {
    return new ProgramCommand(
        scene.map(file -> List.of("enrich", file.toString())).orElse(List.of("enrich")));
  }

  /** Opens the study window. */
  public static ProgramCommand studies(Optional<Path> study) {
    return new ProgramCommand(
        study
            .map(file -> List.of("experiment", "--study", file.toString()))
            .orElse(List.of("experiment")));
  }

  /** Checks this machine. */
  public static ProgramCommand doctor() {
    return new ProgramCommand(List.of("doctor"));
  }
}
