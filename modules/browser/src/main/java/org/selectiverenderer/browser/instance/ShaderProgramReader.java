package org.selectiverenderer.browser.instance;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.ShaderProgramSource.Part;
import org.selectiverenderer.browser.instance.ShaderProgramSource.ProgramField;
import org.selectiverenderer.browser.instance.ShaderProgramSource.Stage;
import org.selectiverenderer.browser.nodes.shader.ShaderNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.shader.ShaderSource;

/** Reads the shaders of an Appearance (X3D 4.0, 31.2.2). */
final class ShaderProgramReader {
  private ShaderProgramReader() {}

  /**
   * Returns the usable shader programs in order of preference: those in GLSL with a source for
   * every part.
   */
  static List<ShaderProgramSource> read(
      @Nullable Node appearance, @Nullable Node geometry, AssetProvider assets) {
    if (appearance == null
        || !appearance.type().name().equals("Appearance")
        || appearance.nodes("shaders").isEmpty()) {
      return List.of();
    }
    List<TextureUnit> textures = TextureUnits.of(appearance, geometry, assets).units();
    List<ShaderProgramSource> programs = new ArrayList<>();
    for (Node node : appearance.nodes("shaders")) {
      if (node instanceof ShaderNode shader && ours(shader)) {
        program(shader, textures, assets).ifPresent(programs::add);
      }
    }
    return List.copyOf(programs);
  }

  private static boolean ours(ShaderNode shader) {
    String language = shader.string("language").strip().toUpperCase(Locale.ROOT);
    return language.equals("GLSL") || language.isEmpty();
  }

  private static Optional<ShaderProgramSource> program(
      ShaderNode shader, List<TextureUnit> textures, AssetProvider assets) {
    List<Node> holders = new ArrayList<>();
    switch (shader.type().name()) {
      case "ComposedShader" -> holders.addAll(shader.nodes("parts"));
      case "ProgramShader" -> holders.addAll(shader.nodes("programs"));
      default -> {
        return Optional.empty();
      }
    }
    List<Part> parts = new ArrayList<>();
    List<ProgramField> fields = new ArrayList<>(fields(shader, assets));
    for (Node holder : holders) {
      Optional<Stage> stage = Stage.named(holder.string("type"));
      Optional<ShaderSource> text = assets.shader(holder);
      if (stage.isEmpty() || text.isEmpty()) {
        return Optional.empty();
      }
      parts.add(new Part(stage.get(), text.get()));
      fields.addAll(fields(holder, assets));
    }
    return parts.isEmpty()
        ? Optional.empty()
        : Optional.of(
            new ShaderProgramSource(shader, List.copyOf(parts), List.copyOf(fields), textures));
  }

  private static List<ProgramField> fields(Node holder, AssetProvider assets) {
    List<FieldDefinition> all = holder.type().fields();
    List<ProgramField> own = new ArrayList<>();
    for (FieldDefinition field : all.subList(holder.type().ownFrom(), all.size())) {
      List<TextureSource> textures = new ArrayList<>();
      if (field.type() == FieldType.MFNode) {
        holder
            .nodes(field.name())
            .forEach(node -> TextureReader.read(node, assets).ifPresent(textures::add));
      } else if (field.type() == FieldType.SFNode) {
        TextureReader.read(holder.node(field.name()), assets).ifPresent(textures::add);
      }
      own.add(
          new ProgramField(
              holder, field.index(), field.name(), field.type(), List.copyOf(textures)));
    }
    return own;
  }
}
