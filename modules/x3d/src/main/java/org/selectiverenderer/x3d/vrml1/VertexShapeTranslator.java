package org.selectiverenderer.x3d.vrml1;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.source.ElementTreeBuilder;
import org.selectiverenderer.x3d.vrml1.AppearanceTranslator.Kind;
import org.selectiverenderer.x3d.vrml1.Vrml1Node.Field;
import org.selectiverenderer.x3d.vrml1.Vrml1State.Property;

/** Translates IndexedFaceSet, IndexedLineSet and PointSet. */
final class VertexShapeTranslator {
  /** A digit, a point and what is between numbers. */
  private static final long SHORTEST_NUMBER = 4;

  private static final String POINT = "point";
  private static final String COORD_INDEX = "coordIndex";

  private final ElementTreeBuilder document;
  private final Vrml1Values values;
  private final SharedElements shared;
  private final Vrml1State.Reader state;
  private final AppearanceTranslator appearances;

  VertexShapeTranslator(
      ElementTreeBuilder document,
      Vrml1Values values,
      SharedElements shared,
      Vrml1State.Reader state,
      AppearanceTranslator appearances) {
    this.document = document;
    this.values = values;
    this.shared = shared;
    this.state = state;
    this.appearances = appearances;
  }

  /** A material binding or a normal binding means this for a shape. */
  private record Binding(boolean perVertex, boolean perPiece, boolean perPart, boolean indexed) {
    static Binding of(String word) {
      return new Binding(
          word.startsWith("PER_VERTEX"),
          word.startsWith("PER_FACE"),
          word.startsWith("PER_PART"),
          word.endsWith("_INDEXED"));
    }
  }

  /**
   * Returns the Shape of a node; null if it shows nothing, which is told.
   *
   * @param copy whether the node has been translated before
   */
  @Nullable X3dElement shape(Vrml1Node node, String type, boolean copy) {
    Vrml1Node points = state.read(Property.COORDINATES);
    int count = values.count(points, POINT) / 3;
    if (points == null || count == 0) {
      String what = "no Coordinate3 with points stands before this %s, which shows nothing";
      document.leftOut(node.typeAt(), what.formatted(type));
      return null;
    }
    if (type.equals("PointSet")) {
      return points(node, points, count);
    }
    int[] indices = values.indices(node, COORD_INDEX);
    if (indices == null) {
      document.leftOut(node.typeAt(), "this " + type + " has no coordIndex and shows nothing");
      return null;
    }
    X3dElement geometry = X3dElement.atType(type, node);
    boolean faces = type.equals("IndexedFaceSet");
    Binding binding = Binding.of(values.word(state.read(Property.MATERIAL_BINDING), "value"));
    Vrml1Node material = state.read(Property.MATERIAL);
    String colours = material == null ? null : appearances.severalColours(material);
    boolean segments = !faces && binding.perPart() && colours != null;
    Field written = node.field(COORD_INDEX);
    if (segments) {
      geometry.set(COORD_INDEX, IndexLists.segments(indices), node.typeAt());
    } else if (written != null) {
      list(geometry, COORD_INDEX, written, copy);
    }
    X3dElement colour = null;
    if (material != null && colours != null) {
      int pieces = segments ? IndexLists.segmentCount(indices) : IndexLists.pieces(indices);
      Pieces all = new Pieces(node, indices, pieces, copy);
      colour = colour(geometry, all, binding, material, colours);
    }
    X3dElement shape = X3dElement.of("Shape", node);
    Kind lit = colour == null ? Kind.LIT : Kind.COLOURED;
    Kind unlit = colour == null ? Kind.UNLIT : Kind.UNLIT_COLOURED;
    shape.add(appearances.appearance(node, faces ? lit : unlit, 0));
    X3dElement normal = faces ? normal(geometry, node, indices, copy) : null;
    X3dElement texture = faces ? textureCoordinate(geometry, node, indices, copy) : null;
    if (faces) {
      hints(geometry, node);
    }
    geometry.add(shared.once(points, node.open(), () -> property("Coordinate", points, POINT)));
    for (X3dElement child : new @Nullable X3dElement[] {colour, normal, texture}) {
      if (child != null) {
        geometry.add(child);
      }
    }
    return shape.add(geometry);
  }

  /** The faces, lines or segments of a shape. */
  private record Pieces(Vrml1Node node, int[] indices, int count, boolean copy) {}

  /** Adds a list as it is written; for a further copy of it, which has no place, as text. */
  private void list(X3dElement geometry, String name, Field field, boolean copy) {
    if (copy) {
      geometry.set(name, values.text(field), field);
    } else {
      geometry.setAsWritten(name, field);
    }
  }

  private X3dElement property(String element, Vrml1Node node, String field) {
    X3dElement property = X3dElement.atType(element, node);
    shared.name(property, node);
    Field written = node.field(field);
    return written == null ? property : property.setAsWritten(field, written);
  }

  /** Binds colours to a shape; returns null if one colour counts for all of it. */
  private @Nullable X3dElement colour(
      X3dElement geometry, Pieces pieces, Binding binding, Vrml1Node material, String field) {
    Vrml1Node node = pieces.node();
    boolean perPiece = binding.perPiece() || binding.perPart();
    if (!binding.perVertex() && !perPiece) {
      return null;
    }
    int count = values.count(material, field) / 3;
    int[] written = values.indices(node, "materialIndex");
    Field list = node.field("materialIndex");
    boolean indexed = binding.indexed() && (written != null || binding.perVertex());
    if (indexed && !IndexLists.below(written == null ? pieces.indices() : written, count)) {
      document.leftOut(
          list == null ? node.typeAt() : list.at(),
          "an index of this "
              + node.type()
              + " refers to a colour that its Material does not have; all of it gets the first");
      return null;
    }
    if (indexed && written != null && list != null) {
      list(geometry, "colorIndex", list, pieces.copy());
    } else if (!indexed && binding.perVertex()) {
      String sequence = IndexLists.sequence(pieces.indices(), i -> i % count);
      geometry.set("colorIndex", sequence, node.typeAt());
    } else if (!indexed && pieces.count() > count) {
      geometry.set("colorIndex", IndexLists.count(pieces.count(), i -> i % count), node.typeAt());
    }
    if (perPiece) {
      geometry.set("colorPerVertex", "false", node.typeAt());
    }
    return color(node, material, field);
  }

  private X3dElement color(Vrml1Node shape, Vrml1Node material, String field) {
    return shared.once(
        new ColorKey(material, field), shape.open(), () -> newColor(material, field));
  }

  private record ColorKey(Vrml1Node material, String field) {}

  /** Returns the Color of a material; with transparencies, if they differ, too. */
  private X3dElement newColor(Vrml1Node material, String field) {
    Field written = material.field(field);
    int at = written == null ? material.typeAt() : written.at();
    float[] transparencies = values.numbers(material, "transparency");
    if (transparencies.length < 2) {
      X3dElement color = new X3dElement("Color", at, at);
      return written == null ? color : color.setAsWritten("color", written);
    }
    float[] colours = values.numbers(material, field);
    StringBuilder text = new StringBuilder(8 * colours.length);
    for (int i = 0; 3 * i + 2 < colours.length; i++) {
      float alpha = 1 - transparencies[Math.min(i, transparencies.length - 1)];
      text.append(i == 0 ? "" : ", ");
      text.append(Vrml1Values.tuple(colours[3 * i], colours[3 * i + 1], colours[3 * i + 2], alpha));
    }
    return new X3dElement("ColorRGBA", at, at).set("color", text.toString(), at);
  }

  /** Binds normals to faces; returns null if there are not enough, so that they are computed. */
  private @Nullable X3dElement normal(
      X3dElement geometry, Vrml1Node node, int[] indices, boolean copy) {
    Vrml1Node normals = state.read(Property.NORMALS);
    int count = values.count(normals, "vector") / 3;
    if (normals == null || count == 0) {
      return null;
    }
    String word = values.word(state.read(Property.NORMAL_BINDING), "value");
    Binding binding =
        word.isEmpty() || word.equals("DEFAULT")
            ? new Binding(true, false, false, true)
            : Binding.of(word);
    int faces = IndexLists.pieces(indices);
    int[] written = values.indices(node, "normalIndex");
    Field list = node.field("normalIndex");
    if (binding.indexed() && written != null && list != null) {
      int wanted = binding.perVertex() ? IndexLists.corners(indices) : faces;
      if (!IndexLists.below(written, count) || IndexLists.corners(written) < wanted) {
        return null;
      }
      list(geometry, "normalIndex", list, copy);
    } else if (binding.perVertex() && binding.indexed()) {
      if (!IndexLists.below(indices, count)) {
        return null;
      }
    } else if (binding.perVertex()) {
      if (IndexLists.corners(indices) > count) {
        return null;
      }
      String sequence = IndexLists.sequence(indices, i -> i);
      geometry.set("normalIndex", sequence, node.typeAt());
    } else if (!binding.perPiece() && !binding.perPart()) {
      geometry.set("normalIndex", IndexLists.count(faces, i -> 0), node.typeAt());
    } else if (faces > count) {
      return null;
    }
    if (!binding.perVertex()) {
      geometry.set("normalPerVertex", "false", node.typeAt());
    }
    return shared.once(normals, node.open(), () -> property("Normal", normals, "vector"));
  }

  private @Nullable X3dElement textureCoordinate(
      X3dElement geometry, Vrml1Node node, int[] indices, boolean copy) {
    Vrml1Node points =
        appearances.texture() == null ? null : state.read(Property.TEXTURE_COORDINATES);
    int[] written = values.indices(node, "textureCoordIndex");
    int count = values.count(points, POINT) / 2;
    if (points == null || !IndexLists.below(written == null ? indices : written, count)) {
      return null; // spread over the bounding box
    }
    Field list = node.field("textureCoordIndex");
    if (written != null && list != null) {
      list(geometry, "texCoordIndex", list, copy);
    }
    return shared.once(points, node.open(), () -> property("TextureCoordinate", points, POINT));
  }

  private void hints(X3dElement geometry, Vrml1Node node) {
    Vrml1Node hints = state.read(Property.SHAPE_HINTS);
    String order = values.word(hints, "vertexOrdering");
    boolean known = order.equals("CLOCKWISE") || order.equals("COUNTERCLOCKWISE");
    if (!known || !values.word(hints, "shapeType").equals("SOLID")) {
      geometry.set("solid", "false", node.typeAt());
    }
    if (order.equals("CLOCKWISE")) {
      geometry.set("ccw", "false", node.typeAt());
    }
    if (values.word(hints, "faceType").equals("UNKNOWN_FACE_TYPE")) {
      geometry.set("convex", "false", node.typeAt());
    }
    double crease = values.numbers(hints, "creaseAngle", 0.5f)[0];
    geometry.set("creaseAngle", Vrml1Values.number(Math.max(0, crease)), node.typeAt());
  }

  private @Nullable X3dElement points(Vrml1Node node, Vrml1Node coordinates, int count) {
    int first = (int) Math.max(0, values.numbers(node, "startIndex", 0)[0]);
    float wanted = values.numbers(node, "numPoints", -1)[0];
    int number = (int) Math.min(wanted < 0 ? count : wanted, Math.max(0, count - (long) first));
    if (number == 0) {
      document.leftOut(
          node.typeAt(), "this PointSet begins after the last point of its Coordinate3");
      return null;
    }
    Vrml1Node material = state.read(Property.MATERIAL);
    String colours = material == null ? null : appearances.severalColours(material);
    boolean several =
        material != null
            && colours != null
            && values.word(state.read(Property.MATERIAL_BINDING), "value").startsWith("PER_")
            && values.count(material, colours) / 3 >= number;
    X3dElement geometry = X3dElement.atType("PointSet", node);
    if (number == count) {
      geometry.add(
          shared.once(coordinates, node.open(), () -> property("Coordinate", coordinates, POINT)));
    } else {
      geometry.add(part(node, values.numbers(coordinates, POINT), first, number));
    }
    if (several && material != null && colours != null) {
      geometry.add(color(node, material, colours));
    }
    Kind kind = several ? Kind.UNLIT_COLOURED : Kind.UNLIT;
    X3dElement shape = X3dElement.of("Shape", node);
    return shape.add(appearances.appearance(node, kind, 0)).add(geometry);
  }

  private X3dElement part(Vrml1Node node, float[] all, int first, int number) {
    double[] part = new double[3 * number];
    values.copied(SHORTEST_NUMBER * part.length);
    for (int i = 0; i < part.length; i++) {
      part[i] = all[3 * first + i];
    }
    return new X3dElement("Coordinate", node.open(), node.open())
        .set("point", Vrml1Values.tuple(part), node.open());
  }
}
