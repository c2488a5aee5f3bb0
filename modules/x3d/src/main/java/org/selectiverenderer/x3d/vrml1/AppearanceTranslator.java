package org.selectiverenderer.x3d.vrml1;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.field.FieldTokenizer;
import org.selectiverenderer.x3d.source.ElementTreeBuilder;
import org.selectiverenderer.x3d.vrml1.Vrml1Node.Field;
import org.selectiverenderer.x3d.vrml1.Vrml1State.Property;

/** Translates Material, Texture2 and Texture2Transform. */
final class AppearanceTranslator {
  /** Tells where a shape takes its colours from. */
  enum Kind {
    /** All of it has the colour of the material. */
    LIT,
    /** A Color replaces the diffuse colour. */
    COLOURED,
    /** Lines and points have the diffuse colour without any light. */
    UNLIT,
    /** Lines and points have the colours of a Color. */
    UNLIT_COLOURED
  }

  private record Key(
      @Nullable Vrml1Node material,
      @Nullable Vrml1Node texture,
      @Nullable Vrml1Node transform,
      Kind kind,
      int index) {}

  private static final String DIFFUSE = "diffuseColor";
  private static final String EMISSIVE = "emissiveColor";
  private static final String USUAL_COLOUR = "0.8 0.8 0.8";

  private final ElementTreeBuilder document;
  private final Vrml1Values values;
  private final SharedElements shared;
  private final Vrml1State.Reader state;

  AppearanceTranslator(
      ElementTreeBuilder document,
      Vrml1Values values,
      SharedElements shared,
      Vrml1State.Reader state) {
    this.document = document;
    this.values = values;
    this.shared = shared;
    this.state = state;
  }

  /**
   * Returns the appearance that counts now.
   *
   * @param shape the node of the shape
   * @param index which of the materials counts
   */
  X3dElement appearance(Vrml1Node shape, Kind kind, int index) {
    Vrml1Node material = state.read(Property.MATERIAL);
    boolean unlit = kind == Kind.UNLIT || kind == Kind.UNLIT_COLOURED;
    Vrml1Node texture = unlit ? null : texture();
    Vrml1Node transform = texture == null ? null : state.read(Property.TEXTURE_TRANSFORM);
    if (material == null && texture == null) {
      return make(shape, new Key(null, null, null, kind, 0));
    }
    Key key = new Key(material, texture, transform, kind, index);
    return shared.once(key, shape.open(), () -> make(shape, key));
  }

  /** Returns the Texture2 that counts now, if it has a picture. */
  @Nullable Vrml1Node texture() {
    Vrml1Node texture = state.read(Property.TEXTURE);
    boolean picture =
        texture != null
            && (!values.string(texture, "filename").isEmpty()
                || values.count(texture, "image") > 3);
    return picture ? texture : null;
  }

  /** Returns the field of a material whose colours differ by part, face or vertex, if any. */
  @Nullable String severalColours(Vrml1Node material) {
    return values.count(material, DIFFUSE) > 3
        ? DIFFUSE
        : values.count(material, EMISSIVE) > 3 ? EMISSIVE : null;
  }

  private X3dElement make(Vrml1Node shape, Key key) {
    X3dElement appearance = new X3dElement("Appearance", shape.open(), shape.open());
    X3dElement material = material(shape, key);
    if (material != null) {
      appearance.add(material);
    }
    Vrml1Node texture = key.texture();
    if (texture != null) {
      appearance.add(shared.once(texture, shape.open(), () -> image(texture)));
    }
    Vrml1Node transform = key.transform();
    X3dElement moved = transform == null ? null : textureTransform(transform);
    if (moved != null) {
      appearance.add(moved);
    }
    return appearance;
  }

  /** Returns whether a material has no colours but those that it emits. */
  private boolean emitsOnly(Vrml1Node material) {
    return material.field(DIFFUSE) != null
        && values.count(material, DIFFUSE) == 0
        && values.count(material, EMISSIVE) > 0;
  }

  private @Nullable X3dElement material(Vrml1Node shape, Key key) {
    Vrml1Node node = key.material();
    if (key.kind() == Kind.UNLIT_COLOURED
        || key.kind() == Kind.COLOURED && node != null && emitsOnly(node)) {
      return null; // without a material, a Color is shown as it is
    }
    if (key.kind() == Kind.UNLIT) {
      X3dElement plain =
          node == null
              ? new X3dElement("Material", shape.open(), shape.open())
              : X3dElement.atType("Material", node);
      return plain.set(EMISSIVE, unlitColour(node, key.index()), plain.start());
    }
    if (node == null) {
      return new X3dElement("Material", shape.open(), shape.open());
    }
    X3dElement material = X3dElement.atType("Material", node);
    if (key.kind() == Kind.LIT && key.index() == 0) {
      shared.name(material, node);
    }
    ambient(material, node, key.index());
    if (emitsOnly(node)) {
      material.set(DIFFUSE, "0 0 0", node.typeAt());
    } else if (key.kind() == Kind.LIT) {
      set(material, node, DIFFUSE, 3, key.index());
    }
    set(material, node, "specularColor", 3, key.index());
    if (key.kind() == Kind.LIT || values.count(node, EMISSIVE) == 3) {
      set(material, node, EMISSIVE, 3, key.index());
    }
    set(material, node, "shininess", 1, key.index());
    if (key.kind() == Kind.LIT || values.count(node, "transparency") == 1) {
      set(material, node, "transparency", 1, key.index());
    }
    return material;
  }

  private String unlitColour(@Nullable Vrml1Node node, int index) {
    if (node == null) {
      return USUAL_COLOUR;
    }
    String emitted = value(node, EMISSIVE, 3, index);
    float[] numbers = values.numbers(node, EMISSIVE);
    boolean black = true;
    for (float number : numbers) {
      black &= number == 0;
    }
    if (emitted != null && (!black || emitsOnly(node))) {
      return emitted;
    }
    String diffuse = value(node, DIFFUSE, 3, index);
    return diffuse == null ? USUAL_COLOUR : diffuse;
  }

  /** X3D has the ambient colour as a part of the diffuse one. */
  private void ambient(X3dElement material, Vrml1Node node, int index) {
    Field field = node.field("ambientColor");
    if (field == null) {
      return;
    }
    double ambient = brightness(values.numbers(node, "ambientColor"), index, 0);
    double diffuse = brightness(values.numbers(node, DIFFUSE), index, 0.8);
    double part = diffuse > 0 ? Math.min(1, Math.max(0, ambient / diffuse)) : 0;
    material.set("ambientIntensity", Vrml1Values.number(part), field);
  }

  private static double brightness(float[] colours, int index, double other) {
    if (colours.length < 3) {
      return other;
    }
    int at = 3 * Math.min(index, colours.length / 3 - 1);
    return ((double) colours[at] + colours[at + 1] + colours[at + 2]) / 3;
  }

  private void set(X3dElement element, Vrml1Node node, String name, int width, int index) {
    String value = value(node, name, width, index);
    Field field = node.field(name);
    if (value != null && field != null) {
      element.set(name, value, field);
    }
  }

  /** Returns one value of a list; null if the field is absent or empty. */
  private @Nullable String value(Vrml1Node node, String name, int width, int index) {
    Field field = node.field(name);
    if (field == null) {
      return null;
    }
    float[] numbers = values.numbers(node, name);
    if (numbers.length <= width) {
      String text = values.text(field).strip();
      return text.isEmpty() ? null : text;
    }
    int at = width * Math.min(index, numbers.length / width - 1);
    double[] value = new double[width];
    for (int i = 0; i < width; i++) {
      value[i] = numbers[at + i];
    }
    return Vrml1Values.tuple(value);
  }

  private X3dElement image(Vrml1Node node) {
    String file = values.string(node, "filename");
    Field url = node.field("filename");
    Field pixels = node.field("image");
    X3dElement texture;
    if (!file.isEmpty() && url != null) {
      texture = X3dElement.atType("ImageTexture", node);
      shared.name(texture, node);
      texture.set("url", FieldTokenizer.string(file), url);
    } else {
      texture = X3dElement.atType("PixelTexture", node);
      shared.name(texture, node);
      if (pixels != null) {
        texture.set("image", values.text(pixels).strip(), pixels);
      }
    }
    for (String side : new String[] {"S", "T"}) {
      Field wrap = node.field("wrap" + side);
      if (wrap != null && values.word(node, "wrap" + side).equals("CLAMP")) {
        texture.set("repeat" + side, "false", wrap);
      }
    }
    return texture;
  }

  /**
   * Returns the TextureTransform of a Texture2Transform, which scales and rotates about its centre
   * and then translates, while X3D translates first (X3D 4.0, 18.4.10).
   */
  private @Nullable X3dElement textureTransform(Vrml1Node node) {
    float[] t = values.numbers(node, "translation", 0, 0);
    float[] s = values.numbers(node, "scaleFactor", 1, 1);
    float[] c = values.numbers(node, "center", 0, 0);
    double angle = values.numbers(node, "rotation", 0)[0];
    if (t[0] == 0 && t[1] == 0 && s[0] == 1 && s[1] == 1 && angle == 0) {
      return null;
    }
    if (s[0] == 0 || s[1] == 0 || angle != 0 && s[0] != s[1]) {
      document.leftOut(
          node.typeAt(),
          "a TextureTransform of X3D cannot scale both axes differently and then rotate, nor scale"
              + " by 0; this Texture2Transform is left out");
      return null;
    }
    double cos = Math.cos(angle);
    double sin = Math.sin(angle);
    // the whole is L x + b, with L = R S; X3D's is L (x + t)
    double bx = t[0] + c[0] - (cos * s[0] * c[0] - sin * s[1] * c[1]);
    double by = t[1] + c[1] - (sin * s[0] * c[0] + cos * s[1] * c[1]);
    double tx = (cos * bx + sin * by) / s[0];
    double ty = (-sin * bx + cos * by) / s[1];
    X3dElement transform = X3dElement.atType("TextureTransform", node);
    if (s[0] != 1 || s[1] != 1) {
      transform.set("scale", Vrml1Values.tuple(s[0], s[1]), node.typeAt());
    }
    if (angle != 0) {
      transform.set("rotation", Vrml1Values.number(angle), node.typeAt());
    }
    if (tx != 0 || ty != 0) {
      transform.set("translation", Vrml1Values.tuple(tx, ty), node.typeAt());
    }
    return transform;
  }
}
