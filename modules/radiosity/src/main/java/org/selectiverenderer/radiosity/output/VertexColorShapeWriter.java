package org.selectiverenderer.radiosity.output;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.radiosity.bake.VertexLitScene;
import org.selectiverenderer.radiosity.mesh.Facet;
import org.selectiverenderer.radiosity.mesh.RadiosityMesh;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.x3d.write.TupleListBuilder;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * Writes a shape with lit vertex colours: an IndexedTriangleStripSet with a Color, or ColorRGBA
 * where it is transparent, and no Appearance. Without a material every browser shows the colours as
 * they are (X3D 3.3, 17.2.2.4; X3D 4.0, 17.2.2.5).
 */
final class VertexColorShapeWriter {
  private static final int COLOUR_DECIMALS = 3;

  /** Least number of coordinate steps across a shape's extent: a 50th of a millimetre in a room. */
  private static final double LEAST = 200_000;

  private final VertexLitScene lit;

  VertexColorShapeWriter(VertexLitScene lit) {
    this.lit = lit;
  }

  /** Appends the shape of a body. */
  void append(X3dWriter out, int number, String def) {
    Body body = lit.scene().bodies().get(number);
    RadiosityMesh facets = lit.facets();
    int first = facets.firstOfBody()[number];
    int count = facets.firstOfBody()[number + 1] - first;
    float[] colours = lit.colours(number);
    int decimals = GeometryNumberFormat.decimals(body.mesh(), LEAST);
    boolean translucent = body.transmittance() > 0;
    Map<String, Integer> known = new HashMap<>();
    TupleListBuilder points = GeometryNumberFormat.lines();
    TupleListBuilder shades = GeometryNumberFormat.lines();
    int[] index = new int[3 * count];
    StringBuilder key = new StringBuilder();
    double[] place = new double[3];
    for (int facet = 0; facet < count; facet++) {
      for (int i = 0; i < 3; i++) {
        // A shape whose transform mirrors it is written with its original winding.
        int corner = body.mirrored() && i > 0 ? 3 - i : i;
        place(body, number, facet, corner, place);
        key.setLength(0);
        GeometryNumberFormat.tuple(key, place, decimals);
        int end = key.length();
        key.append(';');
        int at = 9 * facet + 3 * corner;
        GeometryNumberFormat.tuple(
            key, new double[] {colours[at], colours[at + 1], colours[at + 2]}, COLOUR_DECIMALS);
        if (translucent) {
          key.append(' ');
          GeometryNumberFormat.number(key, 1 - body.transmittance(), COLOUR_DECIMALS);
        }
        Integer id = known.get(key.toString());
        if (id == null) {
          id = known.size();
          known.put(key.toString(), id);
          points.next().append(key, 0, end);
          shades.next().append(key, end + 1, key.length());
        }
        index[3 * facet + i] = id;
      }
    }
    out.open("Shape").def(def).open("IndexedTriangleStripSet");
    if (!body.mesh().solid()) {
      out.attribute("solid", "false");
    }
    out.numbers("index", GeometryNumberFormat.strips(index));
    out.open("Coordinate").numbers("point", points.text()).close();
    out.open(translucent ? "ColorRGBA" : "Color").numbers("color", shades.text()).close();
    out.close().close();
  }

  /** Writes the local coordinates of a corner of a body's facet to {@code out}. */
  private void place(Body body, int number, int facet, int corner, double[] out) {
    List<Facet> divided = lit.facets().divided().get(number);
    float[] local = divided == null ? body.mesh().positions() : divided.get(facet).local();
    int at = divided == null ? 3 * body.vertex(facet, corner) : 3 * corner;
    for (int axis = 0; axis < 3; axis++) {
      out[axis] = local[at + axis];
    }
  }
}
