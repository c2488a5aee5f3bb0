package org.selectiverenderer.command.option;

import java.nio.file.Path;
import picocli.CommandLine.Parameters;

/** The parameter that names the scene of a command. */
public final class SceneArgument {
  @Parameters(paramLabel = "SCENE", description = "X3D scene (XML, ClassicVRML, VRML97 or JSON)")
  private Path scene = Path.of("");

  public Path file() {
    return scene;
  }
}
