package org.selectiverenderer.browser.instance;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.joml.Matrix4f;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.TextureUnit.Role;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.tessellate.TextureCoordinateSource;

/** Collects the textures of an Appearance and its material, each with its texture coordinates. */
final class TextureUnits {
  /** The roles in which a surface's only image needs no {@link ExtendedMaterial}. */
  private static final Set<Role> PLAIN = EnumSet.of(Role.MAIN, Role.DIFFUSE, Role.EMISSIVE);

  private final AssetProvider assets;
  private final TextureTransforms transforms;
  private final List<TextureCoordinateSource> coordinates;
  private final List<TextureUnit> units = new ArrayList<>(1);
  private final List<TextureStage> stages = new ArrayList<>(0);
  private boolean ownMain;
  private boolean uncommon;
  private boolean mainTints;

  private TextureUnits(Node appearance, @Nullable Node geometry, AssetProvider assets) {
    this.assets = assets;
    transforms = TextureTransforms.of(appearance);
    coordinates = geometry == null ? List.of() : TextureCoordinateSource.of(geometry);
  }

  static TextureUnits of(Node appearance, @Nullable Node geometry, AssetProvider assets) {
    TextureUnits all = new TextureUnits(appearance, geometry, assets);
    Node material = appearance.node("material");
    all.ofMaterial(material);
    // The material's own texture takes precedence over the Appearance's (X3D 4.0, 12.4.5).
    if (!all.ownMain) {
      all.ofAppearance(appearance.node("texture"));
    }
    return all;
  }

  List<TextureUnit> units() {
    return List.copyOf(units);
  }

  List<TextureStage> stages() {
    return List.copyOf(stages);
  }

  /**
   * Returns whether the surface has at most one plain image, mapped by the mesh's first texture
   * coordinates.
   */
  boolean plain() {
    return !uncommon && units.size() <= 1;
  }

  /** Returns the plain image that gives the surface its colour, or null. */
  @Nullable Texture plainTexture() {
    TextureUnit unit = main();
    return unit != null && unit.source() instanceof Texture texture ? texture : null;
  }

  /** Returns whether that image multiplies the material's colour. */
  boolean plainTints() {
    TextureUnit unit = main();
    return unit != null && (unit.role() == Role.DIFFUSE || mainTints);
  }

  /**
   * Returns the plain image that gives the surface its emissive colour, if it is the only image; or
   * null.
   */
  @Nullable Texture plainGlow() {
    return plain()
            && units.size() == 1
            && units.get(0).role() == Role.EMISSIVE
            && units.get(0).source() instanceof Texture texture
        ? texture
        : null;
  }

  /**
   * Returns the texture transform of the only image as a 3 x 3 matrix, column by column, or null.
   */
  float @Nullable [] plainTransform() {
    TextureUnit unit = plainGlow() == null ? main() : units.get(0);
    if (unit == null || isIdentity(unit.matrix())) {
      return null;
    }
    float[] m = unit.matrix();
    return new float[] {m[0], m[1], 0, m[4], m[5], 0, m[12], m[13], 1};
  }

  private static boolean isIdentity(float[] matrix) {
    return Arrays.equals(matrix, new Matrix4f().get(new float[16]));
  }

  private @Nullable TextureUnit main() {
    for (TextureUnit unit : units) {
      switch (unit.role()) {
        case MAIN, STAGE, DIFFUSE -> {
          return unit;
        }
        default -> {}
      }
    }
    return null;
  }

  private void ofMaterial(@Nullable Node material) {
    switch (material == null ? "" : material.type().name()) {
      case "Material" -> {
        ownMain = add(Role.DIFFUSE, material, "diffuseTexture");
        add(Role.AMBIENT, material, "ambientTexture");
        add(Role.SPECULAR, material, "specularTexture");
        add(Role.SHININESS, material, "shininessTexture");
        add(Role.EMISSIVE, material, "emissiveTexture");
        add(Role.NORMAL, material, "normalTexture");
        add(Role.OCCLUSION, material, "occlusionTexture");
      }
      // Without lighting the normalTexture has no effect (12.4.12).
      case "UnlitMaterial" -> ownMain = add(Role.DIFFUSE, material, "emissiveTexture");
      case "PhysicalMaterial" -> {
        ownMain = add(Role.DIFFUSE, material, "baseTexture");
        add(Role.METALLIC_ROUGHNESS, material, "metallicRoughnessTexture");
        add(Role.EMISSIVE, material, "emissiveTexture");
        add(Role.NORMAL, material, "normalTexture");
        add(Role.OCCLUSION, material, "occlusionTexture");
      }
      default -> {}
    }
  }

  private boolean add(Role role, Node material, String field) {
    if (material.type().field(field).isEmpty()) {
      return false;
    }
    boolean given = material.node(field) != null;
    if (given) {
      add(role, material.node(field), material.string(field + "Mapping"), 0);
    }
    return given;
  }

  private void ofAppearance(@Nullable Node texture) {
    if (texture == null || !texture.type().name().equals("MultiTexture")) {
      if (texture != null && add(Role.MAIN, texture, "", 0)) {
        mainTints =
            units.get(units.size() - 1).source().components() <= 2 || assets.multiplies(texture);
      }
      return;
    }
    uncommon = true;
    List<? extends Node> textures = texture.nodes("texture");
    for (int i = 0; i < textures.size(); i++) {
      String[] modes = at(texture.strings("mode"), i).split("[,/]", 2);
      String mode = name(modes[0]).isEmpty() ? "MODULATE" : name(modes[0]);
      if (!mode.equals("OFF") && add(Role.STAGE, textures.get(i), "", i)) {
        String alpha = modes.length < 2 || name(modes[1]).isEmpty() ? mode : name(modes[1]);
        stages.add(
            new TextureStage(
                mode,
                alpha,
                name(at(texture.strings("source"), i)),
                name(at(texture.strings("function"), i))));
      }
    }
  }

  private static String at(String[] values, int i) {
    return i < values.length ? values[i] : "";
  }

  private static String name(String word) {
    return word.strip().toUpperCase(Locale.ROOT);
  }

  private boolean add(Role role, @Nullable Node texture, String mapping, int channel) {
    TextureSource source = TextureReader.read(texture, assets).orElse(null);
    if (source == null || units.size() == ExtendedMaterial.MOST_UNITS) {
      return false;
    }
    TextureCoordinateSource chosen = coordinates(mapping, channel);
    boolean plane = source instanceof Texture;
    int set = chosen == null ? plane ? 0 : TextureUnit.BOUNDS : chosen.set();
    String mode = "";
    if (set < 0 && chosen != null) {
      // An unknown mode was reported when the mesh was made.
      mode = chosen.unknown() ? "" : chosen.mode();
      set = !chosen.unknown() ? TextureUnit.GENERATED : plane ? 0 : TextureUnit.BOUNDS;
    }
    Matrix4f matrix =
        role == Role.STAGE ? transforms.ofChannel(channel) : transforms.matrix(mapping, 0);
    boolean flat = matrix == null || (matrix.properties() & Matrix4f.PROPERTY_AFFINE) != 0;
    uncommon |= set != 0 || !plane || !flat || !PLAIN.contains(role);
    units.add(
        new TextureUnit(
            role,
            source,
            set,
            mode,
            (matrix == null ? new Matrix4f() : matrix).get(new float[16])));
    return true;
  }

  private @Nullable TextureCoordinateSource coordinates(String mapping, int channel) {
    if (!mapping.isEmpty()) {
      for (TextureCoordinateSource source : coordinates) {
        if (source.mapping().equals(mapping)) {
          return source;
        }
      }
    }
    return coordinates.isEmpty()
        ? null
        : coordinates.get(Math.min(channel, coordinates.size() - 1));
  }
}
