package org.selectiverenderer.x3d.vrml1;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.joml.Matrix3d;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.selectiverenderer.x3d.vrml1.Vrml1Node.Field;

/**
 * Transformations that follow one another. As long as they have the order of a Transform, their
 * fields are kept; else their matrix is decomposed.
 */
final class TransformChain {
  private static final double NEARLY_NOTHING = 1e-7;

  /** The fields of the transformation nodes, and those of a Transform. */
  private static final Map<String, String> FIELDS =
      Map.of(
          "translation", "translation",
          "rotation", "rotation",
          "scaleFactor", "scale",
          "scaleOrientation", "scaleOrientation",
          "center", "center");

  private final Vrml1Values values;
  private final List<Vrml1Node> nodes = new ArrayList<>(3);
  private final Matrix4d matrix = new Matrix4d();
  private boolean simple = true;
  private int start = -1;
  private int end;

  TransformChain(Vrml1Values values) {
    this.values = values;
  }

  boolean isEmpty() {
    return start < 0;
  }

  /** Returns its matrix. */
  Matrix4dc matrix() {
    return matrix;
  }

  /** Empties the chain. */
  void clear() {
    nodes.clear();
    matrix.identity();
    simple = true;
    start = -1;
  }

  /** Appends the transformation of a node of a type. */
  void add(Vrml1Node node, String type) {
    if (node.fields().keySet().stream().noneMatch(field -> isTransformation(field))) {
      return; // no transformation
    }
    begin(node.start(), node.end());
    simple &= !type.equals("MatrixTransform") && (nodes.isEmpty() || order(type) > last());
    nodes.add(node);
    if (!simple) {
      nodes.clear();
    }
    matrix.mul(matrix(node, type));
  }

  private static boolean isTransformation(String field) {
    return FIELDS.containsKey(field) || field.equals("matrix");
  }

  private void begin(int from, int to) {
    start = start < 0 ? from : start;
    end = to;
  }

  /** Returns the place in translation, rotation, scale; a Transform stands alone. */
  private static int order(String type) {
    return switch (type) {
      case "Translation" -> 1;
      case "Rotation" -> 2;
      case "Scale" -> 3;
      default -> 0;
    };
  }

  private int last() {
    int order = order(nodes.get(nodes.size() - 1).type());
    return order == 0 ? Integer.MAX_VALUE : order;
  }

  /** Appends the transformations of another chain. */
  void append(TransformChain other) {
    if (other.isEmpty()) {
      return;
    }
    if (isEmpty()) {
      nodes.addAll(other.nodes);
      simple = other.simple;
    } else {
      nodes.clear();
      simple = false;
    }
    matrix.mul(other.matrix);
    begin(other.start, other.end);
  }

  private Matrix4d matrix(Vrml1Node node, String type) {
    Matrix4d result = new Matrix4d();
    if (type.equals("MatrixTransform")) {
      float[] m = values.numbers(node, "matrix", new float[16]);
      // row vectors by rows are column vectors by columns; a perspective does not count
      return m[15] == 0
          ? result
          : result.set(
              m[0], m[1], m[2], 0, m[4], m[5], m[6], 0, m[8], m[9], m[10], 0, m[12], m[13], m[14],
              1);
    }
    float[] t = values.numbers(node, "translation", 0, 0, 0);
    float[] r = values.numbers(node, "rotation", 0, 0, 1, 0);
    float[] s = values.numbers(node, "scaleFactor", 1, 1, 1);
    float[] o = values.numbers(node, "scaleOrientation", 0, 0, 1, 0);
    float[] c = values.numbers(node, "center", 0, 0, 0);
    result.translate(t[0] + (double) c[0], t[1] + (double) c[1], t[2] + (double) c[2]);
    rotate(result, r, 1);
    rotate(result, o, 1);
    result.scale(s[0], s[1], s[2]);
    rotate(result, o, -1);
    return result.translate(-c[0], -c[1], -c[2]);
  }

  private static void rotate(Matrix4d matrix, float[] r, int sign) {
    double length = Math.sqrt(r[0] * (double) r[0] + r[1] * (double) r[1] + r[2] * (double) r[2]);
    if (length > 0) {
      matrix.rotate(sign * (double) r[3], r[0] / length, r[1] / length, r[2] / length);
    }
  }

  /** Returns a Transform without children. */
  X3dElement transform() {
    X3dElement transform = new X3dElement("Transform", start, end);
    set(transform);
    return transform;
  }

  /** Sets the fields of a Transform. */
  void set(X3dElement transform) {
    if (!simple) {
      setMatrix(transform);
      return;
    }
    for (Vrml1Node node : nodes) {
      for (Map.Entry<String, Field> field : node.fields().entrySet()) {
        String name = FIELDS.get(field.getKey());
        if (name != null) {
          transform.set(name, values.brief(field.getValue()), field.getValue());
        }
      }
    }
  }

  private void setMatrix(X3dElement transform) {
    set(transform, "translation", matrix.m30(), matrix.m31(), matrix.m32());
    Stretch stretch = Stretch.of(matrix);
    rotation(transform, "rotation", stretch.rotation());
    Vector3d scale = stretch.scale();
    if (scale.distance(1, 1, 1) > NEARLY_NOTHING) {
      set(transform, "scale", scale.x, scale.y, scale.z);
      if (Math.abs(scale.x - scale.y) + Math.abs(scale.y - scale.z) > NEARLY_NOTHING) {
        rotation(transform, "scaleOrientation", stretch.orientation());
      }
    }
  }

  private void rotation(X3dElement transform, String field, Matrix3d rotation) {
    Quaterniond q = new Quaterniond().setFromNormalized(rotation).normalize();
    double sine = Math.sqrt(q.x * q.x + q.y * q.y + q.z * q.z);
    if (sine > NEARLY_NOTHING) {
      double angle = 2 * Math.atan2(sine, q.w);
      set(transform, field, q.x / sine, q.y / sine, q.z / sine, angle);
    }
  }

  private void set(X3dElement transform, String field, double... numbers) {
    double largest = 0;
    for (double number : numbers) {
      largest = Math.max(largest, Math.abs(number));
    }
    for (int i = 0; i < numbers.length; i++) {
      if (Math.abs(numbers[i]) < NEARLY_NOTHING * largest) {
        numbers[i] = 0; // what rounding left of nothing
      }
    }
    if (largest > 0 && Double.isFinite(largest)) {
      transform.set(field, Vrml1Values.tuple(numbers), start);
    }
  }

  /**
   * The polar decomposition of a matrix into a rotation and a stretch along three axes (Shoemake
   * and Duff 1992).
   *
   * @param orientation the rotation of the axes of the stretch
   */
  private record Stretch(Matrix3d rotation, Matrix3d orientation, Vector3d scale) {
    static Stretch of(Matrix4dc matrix) {
      Matrix3d m = new Matrix3d(matrix);
      Matrix3d square = new Matrix3d(m).transpose().mul(m);
      Matrix3d axes = new Matrix3d();
      for (int round = 0; round < 32; round++) {
        for (int i = 0; i < 3; i++) {
          rotateAway(square, axes, i, (i + 1) % 3);
        }
      }
      double sign = m.determinant() < 0 ? -1 : 1;
      Vector3d scale = new Vector3d();
      Matrix3d inverse = new Matrix3d(axes);
      Matrix3d turned = new Matrix3d(m).mul(axes);
      Vector3d column = new Vector3d();
      for (int i = 0; i < 3; i++) {
        scale.setComponent(i, sign * Math.sqrt(Math.max(0, square.get(i, i))));
      }
      for (int i = 0; i < 3; i++) {
        turned.getColumn(i, column);
        if (column.length() > 0) {
          turned.setColumn(i, column.mul(1 / scale.get(i)));
        }
      }
      // a flattened axis gets the direction that the two others leave
      for (int i = 0; i < 3; i++) {
        if (scale.get(i) == 0) {
          Vector3d a = turned.getColumn((i + 1) % 3, new Vector3d());
          turned.setColumn(i, a.cross(turned.getColumn((i + 2) % 3, new Vector3d())));
        }
      }
      Matrix3d rotation = turned.mul(inverse.transpose());
      boolean whole = Math.abs(rotation.determinant() - 1) < 1e-3;
      return new Stretch(whole ? rotation : new Matrix3d(), axes, scale);
    }

    /** Rotates axes so that a symmetric matrix loses an element off its diagonal (Jacobi 1846). */
    private static void rotateAway(Matrix3d square, Matrix3d axes, int i, int j) {
      double off = square.get(i, j);
      double all = Math.abs(square.get(i, i)) + Math.abs(square.get(j, j));
      if (!(Math.abs(off) > 1e-14 * all)) {
        return;
      }
      double angle = 0.5 * Math.atan2(2 * off, square.get(i, i) - square.get(j, j));
      Matrix3d turn = new Matrix3d();
      turn.set(i, i, Math.cos(angle)).set(j, j, Math.cos(angle));
      turn.set(i, j, Math.sin(angle)).set(j, i, -Math.sin(angle));
      axes.mul(turn);
      square.set(new Matrix3d(turn).transpose().mul(square).mul(turn));
    }
  }
}
