package org.selectiverenderer.x3d.vrml1;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.field.FieldTokenizer;
import org.selectiverenderer.x3d.vrml1.AppearanceTranslator.Kind;
import org.selectiverenderer.x3d.vrml1.Vrml1Node.Field;
import org.selectiverenderer.x3d.vrml1.Vrml1State.Property;

/** Translates Cube, Sphere, Cone, Cylinder and AsciiText. */
final class PrimitiveTranslator {
  /** A part of a Cone or Cylinder with the field of X3D that shows it. */
  private record Part(String word, String field) {}

  private static final List<Part> CYLINDER =
      List.of(new Part("SIDES", "side"), new Part("TOP", "top"), new Part("BOTTOM", "bottom"));
  private static final List<Part> CONE =
      List.of(new Part("SIDES", "side"), new Part("BOTTOM", "bottom"));

  private final Vrml1Values values;
  private final SharedElements shared;
  private final Vrml1State.Reader state;
  private final AppearanceTranslator appearances;

  PrimitiveTranslator(
      Vrml1Values values,
      SharedElements shared,
      Vrml1State.Reader state,
      AppearanceTranslator appearances) {
    this.values = values;
    this.shared = shared;
    this.state = state;
    this.appearances = appearances;
  }

  /** Returns the Shape of a node, or a Group of the shapes of its parts. */
  X3dElement shape(Vrml1Node node, String type) {
    return switch (type) {
      case "Cube" -> coloursByPart() == null ? plain(node, box(node)) : colouredCube(node);
      case "Sphere" -> plain(node, copy(X3dElement.atType("Sphere", node), node, "radius"));
      case "AsciiText" -> plain(node, text(node));
      default -> parts(node, type);
    };
  }

  private X3dElement plain(Vrml1Node node, X3dElement geometry) {
    return shape(node, geometry, 0);
  }

  private X3dElement shape(Vrml1Node node, X3dElement geometry, int index) {
    return X3dElement.of("Shape", node)
        .add(appearances.appearance(node, Kind.LIT, index))
        .add(geometry);
  }

  private X3dElement copy(X3dElement element, Vrml1Node node, String... fields) {
    for (String name : fields) {
      copyAs(element, node, name, name);
    }
    return element;
  }

  private void copyAs(X3dElement element, Vrml1Node node, String name, String as) {
    Field field = node.field(name);
    if (field != null) {
      element.set(as, values.brief(field), field);
    }
  }

  /** Returns the field of the colours that the parts of a primitive get one after the other. */
  private @Nullable String coloursByPart() {
    Vrml1Node material = state.read(Property.MATERIAL);
    boolean byPart =
        values.word(state.read(Property.MATERIAL_BINDING), "value").startsWith("PER_PART");
    return byPart && material != null ? appearances.severalColours(material) : null;
  }

  private X3dElement box(Vrml1Node node) {
    X3dElement box = X3dElement.atType("Box", node);
    StringBuilder size = new StringBuilder();
    boolean given = false;
    for (String name : new String[] {"width", "height", "depth"}) {
      Field field = node.field(name);
      given |= field != null;
      size.append(size.length() == 0 ? "" : " ");
      size.append(field == null ? "2" : values.brief(field));
    }
    return given ? box.set("size", size.toString(), node.typeAt()) : box;
  }

  /** Returns a cube of faces, in the order in which they take the materials. */
  private X3dElement colouredCube(Vrml1Node node) {
    double x = values.numbers(node, "width", 2)[0] / 2;
    double y = values.numbers(node, "height", 2)[0] / 2;
    double z = values.numbers(node, "depth", 2)[0] / 2;
    StringBuilder points = new StringBuilder();
    double[][] corners = {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
    for (int i = 0; i < 8; i++) {
      points.append(i == 0 ? "" : ", ");
      points.append(Vrml1Values.tuple(corners[i % 4][0], corners[i % 4][1], i < 4 ? -z : z));
    }
    int at = node.typeAt();
    String frontBackLeftRightTopBottom =
        "4 5 6 7 -1 1 0 3 2 -1 0 4 7 3 -1 5 1 2 6 -1 7 6 2 3 -1 0 1 5 4 -1";
    X3dElement faces =
        X3dElement.atType("IndexedFaceSet", node)
            .set("coordIndex", frontBackLeftRightTopBottom, at)
            .set("texCoordIndex", "0 1 2 3 -1 ".repeat(6).strip(), at)
            .set("colorPerVertex", "false", at)
            .add(new X3dElement("Coordinate", at, at).set("point", points.toString(), at))
            .add(
                new X3dElement("TextureCoordinate", at, at).set("point", "0 0, 1 0, 1 1, 0 1", at));
    Vrml1Node material = state.read(Property.MATERIAL);
    String colours = coloursByPart();
    if (material != null && colours != null) {
      float[] all = values.numbers(material, colours);
      StringBuilder six = new StringBuilder();
      for (int i = 0; i < 6; i++) {
        int from = 3 * (i % (all.length / 3));
        six.append(i == 0 ? "" : ", ");
        six.append(Vrml1Values.tuple(all[from], all[from + 1], all[from + 2]));
      }
      faces.add(new X3dElement("Color", at, at).set("color", six.toString(), at));
    }
    return X3dElement.of("Shape", node)
        .add(appearances.appearance(node, Kind.COLOURED, 0))
        .add(faces);
  }

  private X3dElement parts(Vrml1Node node, String type) {
    List<Part> all = type.equals("Cone") ? CONE : CYLINDER;
    List<String> words = values.words(node, "parts");
    List<Part> shown = new ArrayList<>();
    for (Part part : all) {
      if (words.isEmpty() || words.contains("ALL") || words.contains(part.word())) {
        shown.add(part);
      }
    }
    if (coloursByPart() == null) {
      return plain(node, solid(node, type, all, shown));
    }
    X3dElement group = X3dElement.of("Group", node);
    for (Part part : shown) {
      group.add(shape(node, solid(node, type, all, List.of(part)), all.indexOf(part)));
    }
    return group;
  }

  private X3dElement solid(Vrml1Node node, String type, List<Part> all, List<Part> shown) {
    X3dElement solid = X3dElement.atType(type, node);
    copy(solid, node, "bottomRadius", "radius", "height");
    for (Part part : all) {
      if (!shown.contains(part)) {
        solid.set(part.field(), "false", node.typeAt());
      }
    }
    boolean whole = all.size() == shown.size();
    return whole ? solid : solid.set("solid", "false", node.typeAt());
  }

  private X3dElement text(Vrml1Node node) {
    X3dElement text = X3dElement.atType("Text", node);
    Field string = node.field("string");
    if (string != null) {
      text.set("string", values.strings(string), string);
    }
    Field width = node.field("width");
    for (float length : values.numbers(node, "width")) {
      if (length > 0 && width != null) {
        text.set("length", values.text(width).strip(), width);
        break;
      }
    }
    Vrml1Node style = state.read(Property.FONT_STYLE);
    String justification = values.word(node, "justification");
    Field spacing = node.field("spacing");
    FontKey key = new FontKey(style, justification, spacing == null ? "" : values.brief(spacing));
    return text.add(
        style == null ? font(node, key) : shared.once(key, node.open(), () -> font(node, key)));
  }

  private record FontKey(@Nullable Vrml1Node style, String justification, String spacing) {}

  private X3dElement font(Vrml1Node text, FontKey key) {
    Vrml1Node style = key.style();
    X3dElement font =
        style == null
            ? new X3dElement("FontStyle", text.open(), text.open())
            : X3dElement.atType("FontStyle", style);
    int at = font.start();
    Field size = style == null ? null : style.field("size");
    if (size == null) {
      font.set("size", "10", at);
    } else {
      font.set("size", values.brief(size), size);
    }
    String family = values.word(style, "family");
    if (family.equals("SANS") || family.equals("TYPEWRITER")) {
      font.set("family", FieldTokenizer.string(family), at);
    }
    List<String> words = values.words(style, "style");
    String slanted =
        (words.contains("BOLD") ? "BOLD" : "") + (words.contains("ITALIC") ? "ITALIC" : "");
    if (!slanted.isEmpty()) {
      font.set("style", slanted, at);
    }
    if (!key.spacing().isEmpty()) {
      font.set("spacing", key.spacing(), at);
    }
    switch (key.justification()) {
      case "CENTER" -> font.set("justify", "\"MIDDLE\" \"FIRST\"", at);
      case "RIGHT" -> font.set("justify", "\"END\" \"FIRST\"", at);
      default -> {
        // LEFT, as in X3D
      }
    }
    return font;
  }
}
