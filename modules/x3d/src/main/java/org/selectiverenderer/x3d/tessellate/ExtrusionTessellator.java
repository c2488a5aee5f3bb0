package org.selectiverenderer.x3d.tessellate;

import java.util.Arrays;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * Tessellates Extrusion nodes (X3D 4.0, 13.3.5). Around a closed cross-section and along a closed
 * spine the surface is continuous, and smooth depending on the crease angle; the caps never share
 * normals with the sides. Texture coordinates run from 0 to 1 by length along the cross-section (S)
 * and the spine (T).
 */
final class ExtrusionTessellator {
  /** The maximum number of points, as of a sweep of NURBS: a small file can ask for billions. */
  private static final int LIMIT = 1_000_000;

  private final TessellationContext job;
  private final float[] section;
  private final float[] spine;
  private final int across;
  private final int along;
  private final boolean closedSection;
  private final int ring;

  private ExtrusionTessellator(TessellationContext job, float[] section, float[] spine) {
    this.job = job;
    this.section = section;
    this.spine = spine;
    this.across = section.length / 2;
    this.along = spine.length / 3;
    this.closedSection =
        across > 2
            && section[0] == section[2 * across - 2]
            && section[1] == section[2 * across - 1];
    this.ring = closedSection ? across - 1 : across;
  }

  static Mesh mesh(TessellationContext job) {
    NodeView node = job.node();
    boolean solid = node.bool("solid");
    float[] section = node.floats("crossSection");
    float[] spine = node.floats("spine");
    if (section.length < 4 || spine.length < 6) {
      return PrimitiveMeshBuilder.empty(solid);
    }
    for (String field : new String[] {"crossSection", "spine", "scale", "orientation"}) {
      for (float value : node.floats(field)) {
        if (!(Math.abs(value) < Float.POSITIVE_INFINITY)) {
          job.problem("has a " + field + " that is not finite; it is left out");
          return PrimitiveMeshBuilder.empty(solid);
        }
      }
    }
    if ((long) (section.length / 2) * (spine.length / 3) > LIMIT) {
      job.problem("has more than " + LIMIT + " points; it is left out");
      return PrimitiveMeshBuilder.empty(solid);
    }
    return new ExtrusionTessellator(job, section, spine).mesh();
  }

  private Mesh mesh() {
    boolean begin = job.node().bool("beginCap") && ring > 2;
    boolean end = job.node().bool("endCap") && ring > 2;
    int quads = (across - 1) * (along - 1);
    int[] stream = new int[4 * quads + (begin ? ring : 0) + (end ? ring : 0)];
    float[] texCoords = new float[2 * stream.length];
    CoordinatePoints points = CoordinatePoints.of(points(begin, end));
    TriangleListBuilder triangles = new TriangleListBuilder(stream, 2 * quads + 2 * ring);
    PolygonTriangulator splitter = new PolygonTriangulator(points.xyz(), triangles);
    FaceValidator check = new FaceValidator(stream, points, 3);
    sides(stream, texCoords, closesOnItself(points.xyz()));
    int at = 4 * quads;
    int firstOfCap = ring * along;
    if (begin) {
      cap(stream, texCoords, at, firstOfCap, true);
      at += ring;
      firstOfCap += ring;
    }
    if (end) {
      cap(stream, texCoords, at, firstOfCap, false);
    }
    int faces = 0;
    for (int from = 0; from < stream.length; faces++) {
      int to = from + (faces < quads ? 4 : ring);
      if (check.accepts(from, to)) {
        splitter.split(from, to, faces);
      }
      from = to;
    }
    check.report(job, "face");
    splitter.report(job);
    ComposedGeometryMesher surface = new ComposedGeometryMesher(job, points, triangles, faces);
    return surface.mesh(
        null,
        null,
        new VertexAttribute(texCoords, 2, cornerIds(triangles)),
        job.node().number("creaseAngle"));
  }

  private static int[] cornerIds(TriangleListBuilder triangles) {
    return Arrays.copyOf(triangles.corners(), 3 * triangles.count());
  }

  /** Returns the points of the rings along the spine, then those of the caps. */
  private float[] points(boolean begin, boolean end) {
    SpineFrames frames = new SpineFrames(spine);
    float[] xyz = new float[3 * ring * (along + (begin ? 1 : 0) + (end ? 1 : 0))];
    for (int i = 0; i < along; i++) {
      placeRing(frames, i, xyz);
    }
    int at = 3 * ring * along;
    if (begin) {
      System.arraycopy(xyz, 0, xyz, at, 3 * ring);
      at += 3 * ring;
    }
    if (end) {
      System.arraycopy(xyz, 3 * ring * (along - 1), xyz, at, 3 * ring);
    }
    return xyz;
  }

  private void placeRing(SpineFrames frames, int i, float[] xyz) {
    float[] scale = job.node().floats("scale");
    float[] orientation = job.node().floats("orientation");
    int s = 2 * Math.min(i, scale.length / 2 - 1);
    double scaleX = s < 0 ? 1 : scale[s];
    double scaleZ = s < 0 ? 1 : scale[s + 1];
    int o = 4 * Math.min(i, orientation.length / 4 - 1);
    Quaterniond turn = o < 0 ? new Quaterniond() : rotation(orientation, o);
    Vector3d x = frames.xAxis(i);
    Vector3d y = frames.yAxis(i);
    Vector3d z = frames.zAxis(i);
    for (int k = 0; k < ring; k++) {
      Vector3d p = new Vector3d(section[2 * k] * scaleX, 0, section[2 * k + 1] * scaleZ);
      turn.transform(p);
      int at = 3 * (i * ring + k);
      xyz[at] = (float) (spine[3 * i] + p.x * x.x + p.y * y.x + p.z * z.x);
      xyz[at + 1] = (float) (spine[3 * i + 1] + p.x * x.y + p.y * y.y + p.z * z.y);
      xyz[at + 2] = (float) (spine[3 * i + 2] + p.x * x.z + p.y * y.z + p.z * z.z);
    }
  }

  private static Quaterniond rotation(float[] values, int at) {
    boolean turns = values[at] != 0 || values[at + 1] != 0 || values[at + 2] != 0;
    return turns
        ? new Quaterniond().rotationAxis(values[at + 3], values[at], values[at + 1], values[at + 2])
        : new Quaterniond();
  }

  /** Returns whether the last ring of points equals the first, so that the surface is closed. */
  private boolean closesOnItself(float[] xyz) {
    int last = 3 * ring * (along - 1);
    double size = 0;
    double gap = 0;
    for (int i = 0; i < 3 * ring; i++) {
      size = Math.max(size, Math.abs(xyz[i]));
      gap = Math.max(gap, Math.abs((double) xyz[i] - xyz[last + i]));
    }
    return along > 2 && gap <= 1e-6 * size;
  }

  private void sides(int[] stream, float[] texCoords, boolean closed) {
    double[] s = lengths(section, 2);
    double[] t = lengths(spine, 3);
    int at = 0;
    for (int i = 0; i + 1 < along; i++) {
      int above = closed && i + 2 == along ? 0 : i + 1;
      for (int k = 0; k + 1 < across; k++) {
        int beside = closedSection && k + 2 == across ? 0 : k + 1;
        at = corner(stream, texCoords, at, i * ring + k, s[k], t[i]);
        at = corner(stream, texCoords, at, i * ring + beside, s[k + 1], t[i]);
        at = corner(stream, texCoords, at, above * ring + beside, s[k + 1], t[i + 1]);
        at = corner(stream, texCoords, at, above * ring + k, s[k], t[i + 1]);
      }
    }
  }

  /** Adds a cap; the begin cap faces backwards along the spine, so its order is reversed. */
  private void cap(int[] stream, float[] texCoords, int at, int firstPoint, boolean reverse) {
    float minX = Float.POSITIVE_INFINITY;
    float minZ = Float.POSITIVE_INFINITY;
    float maxX = Float.NEGATIVE_INFINITY;
    float maxZ = Float.NEGATIVE_INFINITY;
    for (int k = 0; k < ring; k++) {
      minX = Math.min(minX, section[2 * k]);
      maxX = Math.max(maxX, section[2 * k]);
      minZ = Math.min(minZ, section[2 * k + 1]);
      maxZ = Math.max(maxZ, section[2 * k + 1]);
    }
    double size = Math.max((double) maxX - minX, (double) maxZ - minZ);
    double scale = size > 0 ? 1 / size : 0;
    for (int i = 0; i < ring; i++) {
      int k = reverse ? ring - 1 - i : i;
      double s = ((double) section[2 * k] - minX) * scale;
      double t = ((double) section[2 * k + 1] - minZ) * scale;
      corner(stream, texCoords, at + i, firstPoint + k, s, t);
    }
  }

  private static int corner(
      int[] stream, float[] texCoords, int at, int point, double s, double t) {
    stream[at] = point;
    texCoords[2 * at] = (float) s;
    texCoords[2 * at + 1] = (float) t;
    return at + 1;
  }

  /** Returns the arc length of each point of a polyline, normalized to 0 to 1. */
  private static double[] lengths(float[] polyline, int components) {
    int count = polyline.length / components;
    double[] lengths = new double[count];
    for (int i = 1; i < count; i++) {
      double square = 0;
      for (int c = 0; c < components; c++) {
        double step = (double) polyline[i * components + c] - polyline[(i - 1) * components + c];
        square += step * step;
      }
      lengths[i] = lengths[i - 1] + Math.sqrt(square);
    }
    double total = lengths[count - 1];
    for (int i = 0; i < count; i++) {
      lengths[i] = total > 0 ? lengths[i] / total : (double) i / (count - 1);
    }
    return lengths;
  }
}
