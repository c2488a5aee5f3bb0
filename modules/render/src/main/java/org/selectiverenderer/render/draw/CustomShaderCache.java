package org.selectiverenderer.render.draw;

import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL3;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.WeakHashMap;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.browser.instance.CubeTexture;
import org.selectiverenderer.browser.instance.ShaderProgramSource;
import org.selectiverenderer.browser.instance.ShaderProgramSource.ProgramField;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.browser.instance.TextureSource;
import org.selectiverenderer.browser.instance.VolumeTexture;
import org.selectiverenderer.browser.nodes.shader.ShaderNode;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.render.glsl.GlslTranslator;
import org.selectiverenderer.render.gpu.CustomShaderProgram;
import org.selectiverenderer.render.gpu.GpuTexture;
import org.selectiverenderer.render.trial.ShaderTrialProcess;

/**
 * The compiled custom shaders, each once however many shapes and nodes share its text. Chooses for
 * a shape the first of its shaders that compiles, and reports to the shader nodes and the author.
 */
final class CustomShaderCache {
  /** The image that a sampler shows where the scene has no texture for it. */
  private static final Texture.Image BLACK =
      new Texture.Image(1, 1, 4, new byte[] {0, 0, 0, (byte) 255});

  private static final Texture NO_PLANE = new Texture(BLACK, true, true);
  private static final VolumeTexture NO_VOLUME = new VolumeTexture(BLACK, true, true, true, null);
  private static final CubeTexture NO_CUBE =
      new CubeTexture(List.of(face(), face(), face(), face(), face(), face()), null);

  private final Map<Key, Outcome> outcomes = new HashMap<>();
  private final ShaderTrialProcess trial = new ShaderTrialProcess();
  private final Map<ShaderNode, Set<Key>> told = new WeakHashMap<>();
  private @Nullable GlslTranslator translator;

  /**
   * The source texts and attribute locations that a program is compiled from.
   *
   * @param attributes the locations of vertex attributes beyond position, normal and colour
   */
  private record Key(List<ShaderProgramSource.Part> parts, Map<String, Integer> attributes) {}

  /**
   * What became of a program.
   *
   * @param refusal why it was not compiled in this process, a clause; empty if it was
   */
  private record Outcome(
      Optional<CustomShaderProgram> program,
      Optional<CustomShaderProgram.Failure> failure,
      String refusal) {}

  private static CubeTexture.Face face() {
    return new CubeTexture.Face(BLACK, 0);
  }

  /**
   * Returns the first of a shape's shaders that compiles; null when none does.
   *
   * @param drawn the mesh that is drawn
   * @param textures uploads a texture
   */
  @Nullable CustomShaderBinding choose(
      GL3 gl, ShapeInstance shape, Mesh drawn, Function<TextureSource, GpuTexture> textures) {
    CustomShaderBinding chosen = null;
    List<ShaderProgramSource> refused = new ArrayList<>();
    for (ShaderProgramSource program : shape.programs()) {
      Outcome outcome = outcome(gl, key(program, drawn));
      if (outcome.program().isPresent()) {
        chosen = look(outcome.program().get(), program, textures);
        break;
      }
      refused.add(program);
    }
    for (ShaderProgramSource program : refused) {
      Key key = key(program, drawn);
      Outcome failure = outcomes.get(key);
      shape.judged(
          program.node(),
          false,
          false,
          untold(program, key) ? List.of(problem(program, failure, chosen != null)) : List.of());
    }
    if (chosen != null) {
      ShaderProgramSource program = chosen.source();
      shape.judged(
          program.node(),
          true,
          true,
          untold(program, key(program, drawn)) ? misfits(chosen) : List.of());
    }
    return chosen;
  }

  private boolean untold(ShaderProgramSource program, Key key) {
    return told.computeIfAbsent(program.node(), node -> new HashSet<>()).add(key);
  }

  private static Key key(ShaderProgramSource program, Mesh mesh) {
    Map<String, Integer> attributes = new LinkedHashMap<>();
    int coordinates = 0;
    for (int i = 0; i < mesh.moreTexCoords().size(); i++) {
      String name = mesh.moreTexCoords().get(i).name();
      if (name.isEmpty()) {
        coordinates++;
        for (String of : List.of("sr_MultiTexCoord", "x3d_TexCoord", "castle_MultiTexCoord")) {
          attributes.put(of + coordinates, 4 + i);
        }
      } else if (!name.endsWith("]")) { // The further columns of a matrix follow the first.
        attributes.put(name, 4 + i);
      }
    }
    return new Key(program.parts(), attributes);
  }

  private static final Map<String, Integer> USUAL =
      Map.ofEntries(
          Map.entry("sr_Vertex", 0),
          Map.entry("x3d_Vertex", 0),
          Map.entry("castle_Vertex", 0),
          Map.entry("position", 0),
          Map.entry("sr_Normal", 1),
          Map.entry("x3d_Normal", 1),
          Map.entry("castle_Normal", 1),
          Map.entry("normal", 1),
          Map.entry("sr_Color", 2),
          Map.entry("x3d_Color", 2),
          Map.entry("castle_ColorPerVertex", 2),
          Map.entry("color", 2),
          Map.entry("sr_MultiTexCoord0", 3),
          Map.entry("x3d_TexCoord", 3),
          Map.entry("x3d_TexCoord0", 3),
          Map.entry("castle_MultiTexCoord0", 3),
          Map.entry("castle_TexCoord0", 3),
          Map.entry("texcoord", 3));

  private Outcome outcome(GL3 gl, Key key) {
    Outcome known = outcomes.get(key);
    if (known == null) {
      GlslTranslator translating = translator == null ? new GlslTranslator() : translator;
      translator = translating;
      Map<String, Integer> attributes = new HashMap<>(USUAL);
      attributes.putAll(key.attributes());
      known =
          tried(
              gl,
              translating.translate(
                  key.parts().stream()
                      .map(part -> new GlslTranslator.Given(part.stage(), part.text().text()))
                      .toList()),
              attributes);
      outcomes.put(key, known);
    }
    return known;
  }

  private Outcome tried(GL3 gl, List<GlslTranslator.Unit> units, Map<String, Integer> attributes) {
    Optional<String> refusal = trial.refusal(units, attributes);
    if (refusal.isPresent()) {
      return new Outcome(Optional.empty(), Optional.empty(), refusal.get());
    }
    CustomShaderProgram.Outcome compiled = CustomShaderProgram.of(gl, units, attributes);
    return new Outcome(compiled.program(), compiled.failure(), "");
  }

  private static Problem problem(ShaderProgramSource program, Outcome outcome, boolean another) {
    String consequence =
        another
            ? "the next shader of the Appearance is used"
            : "the shape is drawn by its material";
    if (outcome.failure().isEmpty()) {
      return new Problem(
          Problem.Severity.ERROR,
          program.node().location(),
          "%s is not used, since %s; %s".formatted(program.node(), outcome.refusal(), consequence));
    }
    CustomShaderProgram.Failure failure = outcome.failure().get();
    GlslTranslator.Unit unit = failure.unit().filter(of -> of.part() >= 0).orElse(null);
    int line = unit == null ? 0 : failure.log().line() - unit.head();
    return new Problem(
        Problem.Severity.ERROR,
        unit == null || line < 1
            ? program.node().location()
            : program.parts().get(unit.part()).text().at(line, failure.log().column()),
        "%s: %s; %s"
            .formatted(
                unit == null
                    ? "the shader stages of " + program.node() + " do not link"
                    : "the " + unit.stage() + " shader of " + program.node() + " does not compile",
                failure.log().message(),
                consequence));
  }

  /** Returns a warning for each field whose type differs from that of the uniform of its name. */
  private static List<Problem> misfits(CustomShaderBinding look) {
    List<Problem> problems = new ArrayList<>();
    Map<String, ProgramField> fields = fields(look.source());
    for (CustomShaderProgram.Uniform uniform : look.program().uniforms()) {
      ProgramField field = fields.get(uniform.name());
      if (field != null && !field.type().isNode() && !fits(field, uniform)) {
        problems.add(
            new Problem(
                Problem.Severity.WARNING,
                field.holder().location(),
                "the field %s of %s (%s) %s; the uniform keeps its own value"
                    .formatted(
                        field.name(), field.holder(), field.type(), misfit(field, uniform))));
      }
    }
    return problems;
  }

  private static String misfit(ProgramField field, CustomShaderProgram.Uniform uniform) {
    return numbers(field)
        ? "has %s components, but the uniform of that name has %s"
            .formatted(field.type().components(), uniform.components())
        : "cannot be a uniform: shaders take no strings and no image fields";
  }

  private static boolean fits(ProgramField field, CustomShaderProgram.Uniform uniform) {
    return numbers(field) && field.type().components() == uniform.components();
  }

  /** Returns whether the field's type can be a uniform: strings and images cannot. */
  private static boolean numbers(ProgramField field) {
    return switch (field.type()) {
      case SFString, MFString, SFImage, MFImage -> false;
      default -> true;
    };
  }

  private static Map<String, ProgramField> fields(ShaderProgramSource source) {
    Map<String, ProgramField> fields = new HashMap<>();
    source.fields().forEach(field -> fields.putIfAbsent(field.name(), field));
    return fields;
  }

  private static CustomShaderBinding look(
      CustomShaderProgram program,
      ShaderProgramSource source,
      Function<TextureSource, GpuTexture> textures) {
    Map<String, ProgramField> fields = fields(source);
    List<CustomShaderBinding.Number> numbers = new ArrayList<>();
    for (CustomShaderProgram.Uniform uniform : program.uniforms()) {
      ProgramField field = fields.get(uniform.name());
      if (field != null && !field.type().isNode()) {
        numbers.add(
            new CustomShaderBinding.Number(uniform, fits(field, uniform) ? field : null, null));
      } else {
        BuiltInUniforms.Value value =
            BuiltInUniforms.of(uniform.name(), uniform.components()).orElse(null);
        numbers.add(new CustomShaderBinding.Number(uniform, null, value));
      }
    }
    List<Optional<GpuTexture>> images = new ArrayList<>();
    for (CustomShaderProgram.Uniform sampler : program.samplers()) {
      for (int i = 0; i < sampler.size(); i++) {
        ProgramField field = fields.get(sampler.name());
        images.add(texture(sampler, field, i, source).map(textures));
      }
    }
    return new CustomShaderBinding(program, source, List.copyOf(numbers), List.copyOf(images));
  }

  /** Returns the texture that a sampler shows; a black one when the scene has none of its type. */
  private static Optional<TextureSource> texture(
      CustomShaderProgram.Uniform sampler,
      @Nullable ProgramField field,
      int element,
      ShaderProgramSource of) {
    TextureSource found = null;
    if (field != null && field.type().isNode()) {
      found = element < field.textures().size() ? field.textures().get(element) : null;
    } else {
      // As in OpenGL, a sampler's value is the number of a texture unit, 0 by default.
      int unit = sampler.name().startsWith("x3d_") ? element : 0;
      if (field != null) {
        float[] given = CustomShaderBinding.floats(field.type(), field.value());
        unit = element < given.length ? (int) given[element] : -1;
      }
      found = unit >= 0 && unit < of.textures().size() ? of.textures().get(unit).source() : null;
    }
    TextureSource none =
        switch (sampler.type()) {
          case GL2ES2.GL_SAMPLER_2D -> NO_PLANE;
          case GL2ES2.GL_SAMPLER_3D -> NO_VOLUME;
          case GL2ES2.GL_SAMPLER_CUBE -> NO_CUBE;
          default -> null;
        };
    if (none == null) {
      return Optional.empty();
    }
    return Optional.of(found != null && sameKind(found, none) ? found : none);
  }

  private static boolean sameKind(TextureSource one, TextureSource other) {
    return one.cube() ? other.cube() : one.getClass() == other.getClass();
  }

  /** Ends the process that tries programs. To be called after {@link #keepOnly}, at the end. */
  void close() {
    trial.close();
  }

  /** Frees the programs that none of the items uses. */
  void keepOnly(GL3 gl, List<DrawItem> items) {
    if (outcomes.isEmpty()) {
      return;
    }
    Set<Key> used = new HashSet<>();
    for (DrawItem item : items) {
      for (ShaderProgramSource program : item.shape().programs()) {
        used.add(key(program, item.source()));
      }
    }
    outcomes
        .entrySet()
        .removeIf(
            entry -> {
              boolean unused = !used.contains(entry.getKey());
              if (unused) {
                entry.getValue().program().ifPresent(program -> program.dispose(gl));
              }
              return unused;
            });
  }
}
