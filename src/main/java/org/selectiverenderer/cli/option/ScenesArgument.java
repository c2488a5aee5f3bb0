package org.selectiverenderer.cli.option;

import java.util.List;
import picocli.CommandLine.Parameters;

/** The parameter that names the scenes of a command. */
public final class ScenesArgument {
  @Parameters(
      paramLabel = "SCENE",
      arity = "1..*",
      description =
          "X3D scenes (.x3d, .x3dv, .wrl, .x3dj ...), folders of scenes, patterns such as"
              + " 'scenes/*.x3d'")
  private List<String> names = List.of();

  public FileArguments files() {
    return new FileArguments(names);
  }
}
