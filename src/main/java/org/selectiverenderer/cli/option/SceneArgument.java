package org.selectiverenderer.cli.option;

import java.nio.file.Path;
import picocli.CommandLine.Parameters;

/** The scene that a command is about. */
public final class SceneArgument {
  @Parameters(paramLabel = "SCENE", description = "X3D scene (XML, ClassicVRML, VRML97 or JSON)")
  private Path scene = Path.of("");

  public Path file() {
    return scene;
  }
}
