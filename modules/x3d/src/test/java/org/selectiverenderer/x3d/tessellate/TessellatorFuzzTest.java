package org.selectiverenderer.x3d.tessellate;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.read.ParsedNode;

/** Whatever a file gives, a sound mesh comes out and no exception. */
class TessellatorFuzzTest extends AbstractTessellatorTest {
  private final Random random = new Random(20260101);

  @ParameterizedTest
  @ValueSource(
      strings = {
        "Box",
        "Cone",
        "Cylinder",
        "Sphere",
        "IndexedFaceSet",
        "IndexedTriangleSet",
        "IndexedTriangleStripSet",
        "IndexedTriangleFanSet",
        "TriangleSet",
        "TriangleStripSet",
        "TriangleFanSet",
        "QuadSet",
        "IndexedQuadSet",
        "IndexedLineSet",
        "LineSet",
        "PointSet",
        "ElevationGrid",
        "Extrusion",
        "Text",
        "Rectangle2D",
        "Disk2D",
        "ArcClose2D",
        "Arc2D",
        "Circle2D",
        "Polyline2D",
        "Polypoint2D",
        "TriangleSet2D"
      })
  void anyValuesGiveASoundMesh(String type) {
    for (int i = 0; i < 3000; i++) {
      MeshProperties.assertSound(mesh(random(type)));
    }
  }

  /** Fewer of these, which take longer. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "GeoElevationGrid",
        "NurbsCurve",
        "NurbsPatchSurface",
        "NurbsSweptSurface",
        "NurbsSwungSurface",
        "NurbsTrimmedSurface"
      })
  void anyValuesGiveASoundCurvedMesh(String type) {
    for (int i = 0; i < 100; i++) {
      MeshProperties.assertSound(mesh(random(type)));
    }
  }

  private NodeView random(String type) {
    ParsedNode node = node(type);
    for (FieldDefinition field : node.type().fields()) {
      if (random.nextInt(8) == 0) {
        continue;
      }
      Object value = field.type().isNode() ? child(node, field.name()) : value(field);
      if (value != null) {
        node.put(field.index(), value);
      }
    }
    return node;
  }

  private Object child(ParsedNode parent, String field) {
    return switch (field) {
      case "coord" ->
          random(
              switch (random.nextInt(9)) {
                case 0 -> "CoordinateDouble";
                case 1 -> "GeoCoordinate";
                default -> "Coordinate";
              });
      case "controlPoint" -> random("Coordinate");
      case "geoOrigin" -> random("GeoOrigin");
      case "crossSectionCurve", "profileCurve" ->
          random(random.nextBoolean() ? "NurbsCurve2D" : "ContourPolyline2D");
      case "trajectoryCurve" ->
          random(parent.type().name().equals("NurbsSweptSurface") ? "NurbsCurve" : "NurbsCurve2D");
      case "trimmingContour" -> List.of(random("Contour2D"), random("Contour2D"));
      case "children" -> List.of(random("NurbsCurve2D"), random("ContourPolyline2D"));
      case "color" -> random.nextInt(3) == 0 ? random("ColorRGBA") : random("Color");
      case "normal" -> random("Normal");
      case "texCoord" -> random("TextureCoordinate");
      case "fontStyle" -> random("FontStyle");
      default -> null;
    };
  }

  private Object value(FieldDefinition field) {
    boolean many = field.type().multiple();
    int components = Math.max(1, field.type().components());
    int length = many ? components * random.nextInt(30) + random.nextInt(3) / 2 : components;
    switch (field.type().kind()) {
      case BOOLEAN:
        return random.nextBoolean();
      case INT:
        int[] ints = new int[length];
        for (int i = 0; i < length; i++) {
          ints[i] = random.nextInt(40) == 0 ? random.nextInt() : random.nextInt(12) - 1;
        }
        return many ? ints : (Object) Integer.valueOf(ints[0]);
      case FLOAT:
        float[] floats = new float[length];
        for (int i = 0; i < length; i++) {
          floats[i] = number();
        }
        return many || components > 1 ? floats : (Object) Float.valueOf(floats[0]);
      case DOUBLE:
        double[] doubles = new double[length];
        for (int i = 0; i < length; i++) {
          doubles[i] = number();
        }
        return many || components > 1 ? doubles : (Object) Double.valueOf(doubles[0]);
      case STRING:
        String[] strings = new String[length];
        for (int i = 0; i < length; i++) {
          strings[i] = random.nextInt(3) == 0 ? "MIDDLE" : word();
        }
        return many ? strings : strings[0];
      default:
        return null;
    }
  }

  /** Small whole numbers mostly, so that points coincide and faces are degenerate. */
  private float number() {
    return switch (random.nextInt(60)) {
      case 0 -> Float.NaN;
      case 1 -> Float.POSITIVE_INFINITY;
      case 2 -> Float.MAX_VALUE;
      case 3 -> Float.MIN_VALUE;
      case 4 -> -0.0f;
      case 5 -> -1e20f;
      default -> random.nextBoolean() ? random.nextInt(5) - 1 : (float) random.nextGaussian() * 10;
    };
  }

  private String word() {
    StringBuilder word = new StringBuilder();
    for (int i = random.nextInt(6); i > 0; i--) {
      word.appendCodePoint(random.nextInt(0x3000));
    }
    return word.toString();
  }
}
