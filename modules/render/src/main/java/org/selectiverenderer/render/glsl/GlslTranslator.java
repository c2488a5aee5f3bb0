package org.selectiverenderer.render.glsl;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.browser.instance.ShaderProgramSource.Stage;

/**
 * Translates the stages of a custom shader to the GLSL of OpenGL 3.3's core profile: GLSL 3.30, or
 * a later version that the author asks for. Works token by token and keeps the author's line
 * structure.
 */
public final class GlslTranslator {
  private static final int OLDEST = 330;
  private static final Pattern VERSION = Pattern.compile("#\\s*version\\s+(\\d+)(?:\\s+(\\w+))?");
  private static final Pattern EXTENSION = Pattern.compile("#\\s*extension\\s+(\\w+)");

  /** Keywords that were allowed as names before GLSL 1.30. */
  private static final Set<String> LATER_WORDS =
      Set.of(
          "smooth",
          "flat",
          "noperspective",
          "uint",
          "uvec2",
          "uvec3",
          "uvec4",
          "switch",
          "case",
          "layout",
          "sample",
          "patch",
          "buffer",
          "shared",
          "precise",
          "subroutine");

  private static final String DEFAULT_VERTEX =
      """
      void main() {
        gl_FrontColor = gl_Color;
        gl_TexCoord[0] = gl_TextureMatrix[0] * gl_MultiTexCoord0;
        gl_Position = ftransform();
      }
      """;

  private static final String DEFAULT_FRAGMENT = "void main() { gl_FragColor = gl_Color; }\n";

  private static final String DEFAULT_COLOR =
      "void main() { gl_FragColor = gl_FrontMaterial.diffuse; }\n";

  private final BuiltInDeclarations names = new BuiltInDeclarations();

  /**
   * A translated source to compile.
   *
   * @param part the index of the author's source, from 0; -1 for a default stage
   * @param head the number of lines before the author's first line; {@code #line} could hide them,
   *     but drivers count differently after it
   */
  public record Unit(Stage stage, int part, int head, String text) {}

  /** A source of the author's. */
  public record Given(Stage stage, String text) {}

  /** A source with its tokens. */
  private record Part(Given given, int number, GlslTokens tokens, boolean old) {}

  /**
   * Returns the sources of a program: those given, and a default for each missing stage, which does
   * what OpenGL's fixed-function pipeline did.
   */
  public List<Unit> translate(List<Given> given) {
    List<Part> parts = new ArrayList<>();
    for (int i = 0; i < given.size(); i++) {
      parts.add(part(given.get(i), i));
    }
    boolean colored = parts.stream().anyMatch(part -> uses(part, "gl_FrontColor"));
    if (none(parts, Stage.VERTEX)) {
      parts.add(part(new Given(Stage.VERTEX, DEFAULT_VERTEX), -1));
      colored = true;
    }
    if (none(parts, Stage.FRAGMENT)) {
      String text = colored ? DEFAULT_FRAGMENT : DEFAULT_COLOR;
      parts.add(part(new Given(Stage.FRAGMENT, text), -1));
    }
    int version = parts.stream().mapToInt(GlslTranslator::version).max().orElse(OLDEST);
    Map<Stage, Set<String>> passed = new EnumMap<>(Stage.class);
    passed.put(Stage.VERTEX, passed(parts));
    return parts.stream().map(part -> unit(part, version, passed)).toList();
  }

  private static boolean none(List<Part> parts, Stage stage) {
    return parts.stream().noneMatch(part -> part.given().stage() == stage);
  }

  private static boolean uses(Part part, String name) {
    return part.tokens().names().contains(name);
  }

  private static Part part(Given given, int number) {
    GlslTokens tokens = GlslTokens.of(given.text().replace("\r\n", "\n").replace('\r', '\n'));
    return new Part(given, number, tokens, declared(tokens).map(v -> v < 130).orElse(true));
  }

  /**
   * Returns the version that a source asks for; for OpenGL ES the corresponding desktop version.
   */
  private static Optional<Integer> declared(GlslTokens tokens) {
    for (GlslTokens.Token token : tokens.list()) {
      Matcher version = VERSION.matcher(token.text());
      if (token.kind() == GlslTokens.Kind.FIRST && version.find()) {
        int number = version.group(1).length() > 4 ? OLDEST : Integer.parseInt(version.group(1));
        boolean es = "es".equals(version.group(2)) || number == 100;
        return Optional.of(es ? number == 100 ? 100 : OLDEST : number);
      }
    }
    return Optional.empty();
  }

  private static int version(Part part) {
    return Math.max(OLDEST, declared(part.tokens()).orElse(OLDEST));
  }

  /** Returns the built-in varyings that the fragment stage reads from the vertex stage. */
  private Set<String> passed(List<Part> parts) {
    Set<String> passed = new HashSet<>();
    for (Part part : parts) {
      if (part.given().stage() == Stage.FRAGMENT) {
        if (uses(part, "gl_Color")) {
          passed.add("sr_FrontColor");
        }
        if (uses(part, "gl_TexCoord")) {
          passed.add("sr_TexCoord");
        }
        if (uses(part, "gl_FogFragCoord")) {
          passed.add("sr_FogFragCoord");
        }
      }
    }
    return passed;
  }

  private Unit unit(Part part, int version, Map<Stage, Set<String>> passed) {
    Stage stage = part.given().stage();
    StringBuilder body = new StringBuilder();
    StringBuilder extensions = new StringBuilder();
    Set<String> used = new HashSet<>(passed.getOrDefault(stage, Set.of()));
    for (GlslTokens.Token token : part.tokens().list()) {
      switch (token.kind()) {
        case FIRST -> extension(token.text()).ifPresent(extensions::append);
        case NAME -> {
          String name = name(part, token.text());
          used.add(name);
          body.append(name);
        }
        default -> body.append(token.text());
      }
    }
    String head =
        "#version %d core\n".formatted(version)
            + extensions
            + names.head(stage, used, part.tokens().defined());
    int lines = (int) head.chars().filter(c -> c == '\n').count();
    return new Unit(stage, part.number(), lines, head + body + "\n");
  }

  /**
   * Returns an extension directive: extensions of OpenGL ES are dropped because desktop GLSL
   * includes them, others are enabled but not required.
   */
  private static Optional<String> extension(String line) {
    Matcher extension = EXTENSION.matcher(line);
    return extension.find()
            && !extension.group(1).startsWith("GL_OES_")
            && !extension.group(1).equals("GL_EXT_frag_depth")
            && !extension.group(1).equals("GL_EXT_shader_texture_lod")
            && !extension.group(1).equals("all")
        ? Optional.of("#extension " + extension.group(1) + " : enable\n")
        : Optional.empty();
  }

  private String name(Part part, String name) {
    Stage stage = part.given().stage();
    return switch (name) {
      case "attribute" -> stage == Stage.VERTEX && part.old() ? "in" : name;
      case "varying" -> !part.old() ? name : stage == Stage.VERTEX ? "out" : "in";
      default -> part.old() && LATER_WORDS.contains(name) ? name + "_" : names.renamed(stage, name);
    };
  }

  /**
   * Returns the field name of a compiled uniform: names that have since become GLSL keywords are
   * compiled with an underscore at the end.
   */
  public static String fieldName(String compiled) {
    return compiled.endsWith("_")
            && LATER_WORDS.contains(compiled.substring(0, compiled.length() - 1))
        ? compiled.substring(0, compiled.length() - 1)
        : compiled;
  }
}
