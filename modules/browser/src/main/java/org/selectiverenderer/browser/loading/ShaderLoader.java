package org.selectiverenderer.browser.loading;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.instance.ShaderProgramSource;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.shader.ShaderSource;
import org.selectiverenderer.x3d.shader.ShaderSourceSelection;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.IoErrorFormatter;
import org.selectiverenderer.x3d.url.UrlContent;
import org.selectiverenderer.x3d.url.UrlResolver;

/** Loads the sources of shader parts. */
final class ShaderLoader {
  private static final String CONSEQUENCE = "the shader is left out";

  private final UrlResolver root;

  ShaderLoader(UrlResolver root) {
    this.root = root;
  }

  /** Returns whether nodes of a type hold the source of one shader stage. */
  static boolean named(NodeType type) {
    return type.name().equals("ShaderPart") || type.name().equals("ShaderProgram");
  }

  /** Returns a problem for an Appearance with shaders of which none is in a supported language. */
  static Optional<Problem> noneOfOurs(ParsedNode appearance) {
    List<? extends NodeView> shaders = appearance.nodes("shaders");
    if (shaders.isEmpty() || shaders.stream().anyMatch(ShaderLoader::ours)) {
      return Optional.empty();
    }
    return Optional.of(
        new Problem(
            Problem.Severity.INFO,
            shaders.get(0).location(),
            "none of the shaders of the Appearance is in GLSL, the only supported language; write a"
                + " ComposedShader with language='GLSL'; the shape is drawn by its material"));
  }

  /** Returns a problem for a shader without any part. */
  static Optional<Problem> withoutParts(ParsedNode shader) {
    String parts =
        switch (shader.type().name()) {
          case "ComposedShader" -> "parts";
          case "ProgramShader" -> "programs";
          default -> "";
        };
    if (parts.isEmpty() || !shader.nodes(parts).isEmpty() || !ours(shader)) {
      return Optional.empty();
    }
    return Optional.of(
        new Problem(
            Problem.Severity.INFO,
            shader.location(),
            "%s has no %s; the shape is drawn by its material"
                .formatted(shader.type().name(), parts)));
  }

  private static boolean ours(NodeView shader) {
    if (shader.type().name().equals("PackagedShader")
        || shader.type().field("language").isEmpty()) {
      return !shader.type().is("X3DShaderNode"); // Else reported by the reader.
    }
    String language = shader.string("language").strip();
    return language.isEmpty() || language.equalsIgnoreCase("GLSL");
  }

  /**
   * Loads the source of a shader part; empty, with a message, if it has no usable one.
   *
   * @param base the base of the part's relative urls
   */
  Optional<ShaderSource> read(ParsedNode part, BaseUrl base, ProblemCollector problems) {
    String type = part.string("type");
    if (ShaderProgramSource.Stage.named(type).isEmpty()) {
      problems.error(
          part.location(),
          "%s type '%s' is not VERTEX, FRAGMENT or GEOMETRY; %s"
              .formatted(part.type().name(), type, CONSEQUENCE));
      return Optional.empty();
    }
    ShaderSourceSelection choice = ShaderSourceSelection.of(part, root, base, CONSEQUENCE);
    if (choice instanceof ShaderSourceSelection.Text text) {
      return Optional.of(text.text());
    }
    if (choice instanceof ShaderSourceSelection.File file) {
      return fromFile(part, file.content(), problems);
    }
    problems.add(((ShaderSourceSelection.None) choice).problem());
    return Optional.empty();
  }

  private static Optional<ShaderSource> fromFile(
      ParsedNode part, UrlContent file, ProblemCollector problems) {
    try {
      return Optional.of(ShaderSource.read(file));
    } catch (IOException e) {
      problems.error(
          part.location(),
          "%s %s; %s".formatted(file.name(), IoErrorFormatter.clause(e), CONSEQUENCE));
      return Optional.empty();
    }
  }
}
