package org.selectiverenderer.runtime.loading;

import java.io.IOException;
import java.util.Optional;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.files.Content;
import org.selectiverenderer.x3d.files.ContentBase;
import org.selectiverenderer.x3d.files.ContentRoot;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.shader.ShaderChoice;
import org.selectiverenderer.x3d.shader.ShaderText;

/** Reads the texts of shaders' parts. */
final class ShaderFiles {
  private static final String CONSEQUENCE = "the shader is left out";

  private final ContentRoot root;

  ShaderFiles(ContentRoot root) {
    this.root = root;
  }

  /** Whether nodes of a type have the text of one stage of a program. */
  static boolean named(NodeType type) {
    return type.name().equals("ShaderPart") || type.name().equals("ShaderProgram");
  }

  /**
   * The text of a part; empty, with a message, when it has none that can be used.
   *
   * @param base where the relative urls of the part start
   */
  Optional<ShaderText> read(ParsedNode part, ContentBase base, Problems problems) {
    ShaderChoice choice = ShaderChoice.of(part, root, base, CONSEQUENCE);
    if (choice instanceof ShaderChoice.Text text) {
      return Optional.of(text.text());
    }
    if (choice instanceof ShaderChoice.File file) {
      return fromFile(part, file.content(), problems);
    }
    problems.add(((ShaderChoice.None) choice).problem());
    return Optional.empty();
  }

  private static Optional<ShaderText> fromFile(ParsedNode part, Content file, Problems problems) {
    try {
      return Optional.of(ShaderText.read(file));
    } catch (IOException e) {
      problems.error(
          part.location(),
          "%s %s; %s".formatted(file.name(), Failure.clause(e), CONSEQUENCE));
      return Optional.empty();
    }
  }
}
