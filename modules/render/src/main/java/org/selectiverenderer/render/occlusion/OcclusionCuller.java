package org.selectiverenderer.render.occlusion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.joml.Matrix4dc;
import org.selectiverenderer.browser.camera.Camera;

/**
 * Occlusion culling: finds what is hidden behind walls and other large flat things in a frame. Call
 * {@link #begin}, {@link #offer} for everything opaque in view, {@link #cover}, then queries, then
 * {@link #end}. It pauses for some frames when it finds little; that changes how much is drawn,
 * never what is seen. Belongs to one thread.
 */
public final class OcclusionCuller {
  /** The most occluding shapes per frame: the largest in view. */
  private static final int MOST_OCCLUDERS = 32;

  /** The most triangles per frame that are searched for occluders; the rest waits. */
  private static final int MOST_UNSEEN = 16_384;

  /** Shapes that can cover fewer cells than this hide too little. */
  private static final double FEWEST_CELLS = 48;

  /** The most frames without occlusion culling after one that found little. */
  private static final int LONGEST_REST = 8;

  /** The number of indices whose drawing costs more than occlusion culling. */
  private static final long WORTHWHILE = 6000;

  private static final long WORTHWHILE_SHARE = 10;

  private final List<EyeOcclusionCuller> depths = new ArrayList<>();
  private final List<MeshOccluders> offered = new ArrayList<>();
  private final List<Matrix4dc> places = new ArrayList<>();
  private long[] order = new long[64];
  private int eyes;
  private boolean on;
  private boolean needed;
  private boolean waiting;
  private int rest;
  private int nextRest = 1;

  /**
   * Begins a frame.
   *
   * @param needed whether it neither pauses nor puts off the search for occluders, because what is
   *     not hidden costs more than drawing
   */
  public void begin(List<Camera> cameras, boolean needed) {
    offered.clear();
    places.clear();
    eyes = cameras.size();
    this.needed = needed;
    on = rest == 0 || needed;
    rest = Math.max(0, rest - 1);
    while (depths.size() < eyes) {
      depths.add(new EyeOcclusionCuller());
    }
    for (int eye = 0; eye < eyes && on; eye++) {
      depths.get(eye).look(cameras.get(eye));
    }
  }

  /** Returns whether a box may hold a shape that is large enough to be an occluder. */
  public boolean offers(double[] box) {
    for (int eye = 0; eye < eyes && on; eye++) {
      if (!(depths.get(eye).mostCells(box) < FEWEST_CELLS)) {
        return true;
      }
    }
    return false;
  }

  /**
   * Offers a shape as an occluder. All of its triangles must be drawn opaquely and as a whole;
   * those of a solid mesh from the front only.
   *
   * @param place the matrix from the coordinates in its buffers to the world
   * @param box min x, y, z, max x, y, z in the world
   */
  public void offer(MeshOccluders occluders, Matrix4dc place, double[] box) {
    if (!on || occluders.none()) {
      return;
    }
    double cells = 0;
    for (int eye = 0; eye < eyes; eye++) {
      cells = Math.max(cells, depths.get(eye).cells(box));
    }
    if (cells >= FEWEST_CELLS) {
      int at = offered.size();
      if (at == order.length) {
        order = Arrays.copyOf(order, 2 * at);
      }
      // The bits of a float that is not negative are in the order of its values.
      order[at] = (long) -Float.floatToIntBits((float) cells) << 32 | at;
      offered.add(occluders);
      places.add(place);
    }
  }

  /**
   * Rasterises the largest occluders that were offered.
   *
   * @return whether there is any occluder, so that queries make sense
   */
  public boolean cover() {
    on &= !offered.isEmpty();
    if (!on) {
      return false;
    }
    Arrays.sort(order, 0, offered.size());
    waiting = false;
    int unseen = 0;
    int used = 0;
    for (int i = 0; i < offered.size() && used < MOST_OCCLUDERS; i++) {
      MeshOccluders occluders = offered.get((int) order[i]);
      // The first is searched however large it is.
      if (needed || unseen == 0 || unseen + occluders.unseen() <= MOST_UNSEEN) {
        unseen += occluders.unseen();
        occluders.find();
      }
      waiting |= occluders.unseen() > 0;
      if (!occluders.patches().isEmpty()) {
        used++;
        cover(occluders, places.get((int) order[i]));
      }
    }
    for (int eye = 0; eye < eyes; eye++) {
      depths.get(eye).finish();
    }
    return used > 0;
  }

  private void cover(MeshOccluders occluders, Matrix4dc world) {
    for (int eye = 0; eye < eyes; eye++) {
      depths.get(eye).cover(occluders, world);
    }
  }

  /**
   * Sets the shape that is queried next.
   *
   * @param place the matrix from the coordinates in its buffers to the world
   * @param shape the shape's own occluders, whose extent determines the rounding errors
   */
  public void ask(Matrix4dc place, MeshOccluders shape) {
    double reach = shape.reach();
    for (int eye = 0; eye < eyes; eye++) {
      depths.get(eye).ask(place, reach);
    }
  }

  /**
   * Sets that boxes with any shapes are queried next.
   *
   * @param terms the greatest of {@link MeshOccluders#terms} of the shapes
   */
  public void ask(double terms) {
    for (int eye = 0; eye < eyes; eye++) {
      depths.get(eye).ask(terms);
    }
  }

  /**
   * Returns whether an eye cannot see anything of a box, because the box is hidden or not in view.
   *
   * @param box min x, y, z, max x, y, z in the world
   * @param pixels the pixels by which points and lines may reach beyond it; 0 for triangles
   */
  public boolean hides(int eye, double[] box, double pixels) {
    return depths.get(eye).hides(box, pixels);
  }

  /** Sets the place of the shape whose triangle clusters are queried next. */
  public void enter(Matrix4dc world) {
    for (int eye = 0; eye < eyes; eye++) {
      depths.get(eye).enter(world);
    }
  }

  /**
   * Returns whether an eye cannot see anything of a sphere in the shape's local coordinates.
   *
   * @param at the index of its centre x, y, z and radius
   */
  public boolean hides(int eye, float[] spheres, int at) {
    return depths.get(eye).hides(spheres, at);
  }

  /**
   * Ends a frame with queries, and decides whether to pause.
   *
   * @param hidden the indices that were culled by occlusion
   * @param drawn the indices that are drawn
   */
  public void end(long hidden, long drawn) {
    if (hidden >= Math.min(WORTHWHILE, drawn / WORTHWHILE_SHARE)) {
      nextRest = 1;
    } else if (!waiting) {
      rest = nextRest;
      nextRest = Math.min(LONGEST_REST, 2 * nextRest);
    }
  }
}
