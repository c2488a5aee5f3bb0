package org.selectiverenderer.cli.option;

import java.nio.file.Path;
import picocli.CommandLine.Parameters;

/** The scene that a command is about. */
public final class SceneArgument {
  @Parameters(paramLabel = "SCENE", description = "X3D scene (.x3d, .x3dz)")
  private Path scene = Path.of("");

  public Path file() {
    return scene;
  }
}
