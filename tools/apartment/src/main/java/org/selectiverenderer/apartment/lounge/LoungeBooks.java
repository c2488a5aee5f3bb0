package org.selectiverenderer.apartment.lounge;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.LoftedSurface;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.VertexWelding;

/** A pile of four bound books, their ribbed spines to the front. */
final class LoungeBooks {
  private static final double COVER = 0.0035;
  private static final int ROWS = 25;

  /** A book's position in the pile and its size, metres and degrees. */
  private record Book(
      String name,
      ModelColour colour,
      double y,
      double width,
      double length,
      double thick,
      double turn,
      double aside) {}

  private static final List<Book> PILE =
      List.of(
          new Book("lowest", ModelColour.of(0.2, 0.13, 0.1), 0, 0.2, 0.27, 0.046, 2, 0),
          new Book("second", ModelColour.of(0.5, 0.14, 0.12), 0.046, 0.18, 0.25, 0.036, -5, 0.01),
          new Book(
              "third", ModelColour.of(0.14, 0.32, 0.34), 0.082, 0.165, 0.235, 0.042, 4, -0.008),
          new Book("top", ModelColour.of(0.72, 0.56, 0.28), 0.124, 0.14, 0.2, 0.028, -12, 0.012));

  private LoungeBooks() {}

  static ParametricModel model() {
    List<Part> parts = new ArrayList<>();
    List<TriangleMesh> pages = new ArrayList<>();
    for (Book book : PILE) {
      parts.add(
          Part.of(book.name, ModelMaterial.satin(book.colour), place(cover(book), book))
              .crease(45));
      pages.add(place(pages(book), book));
    }
    parts.add(Part.of("pages", Materials.CREAM_PAPER, TriangleMesh.of(pages)));
    return ModelPlacement.centred(new ParametricModel("loungeBooks", parts));
  }

  /** Moves a book from lengthways on z to lengthways on x with its spine to +z, turned a little. */
  private static TriangleMesh place(TriangleMesh mesh, Book book) {
    return mesh.turnY(90 + book.turn).move(book.aside, book.y, -book.aside);
  }

  /**
   * Returns two boards and a round spine in one piece, lofted along z over rows of a line that runs
   * outside from the lower board's edge around the spine to the upper board's edge, and back
   * inside. The first and the last row are folded shut.
   */
  private static TriangleMesh cover(Book book) {
    ProfileCurve middle = middle(book);
    List<Vector3d[]> rows = new ArrayList<>();
    for (int r = 0; r <= ROWS + 2; r++) {
      boolean shut = r == 0 || r == ROWS + 2;
      double z = (Math.min(Math.max(r - 1, 0), ROWS) / (double) ROWS - 0.5) * book.length;
      double end = shut ? Math.copySign(0.001, r - 1) : 0;
      rows.add(row(middle, z + end, shut ? 0 : COVER / 2, rib(r - 1), book.thick));
    }
    return VertexWelding.weld(LoftedSurface.over(rows, LoftedSurface.Form.PIPE)).outward();
  }

  /** Returns the centre line of the boards, seen from the end; the spine is at -x. */
  private static ProfileCurve middle(Book book) {
    double half = book.thick / 2 - COVER / 2;
    double joint = 0.012 - book.width / 2;
    return ProfileCurve.from(book.width / 2, COVER / 2)
        .line(joint, COVER / 2)
        .bezier(
            joint - 0.014,
            COVER / 2,
            joint - 0.014,
            COVER / 2 + 2 * half,
            joint,
            COVER / 2 + 2 * half,
            8)
        .line(book.width / 2, COVER / 2 + 2 * half);
  }

  private static Vector3d[] row(
      ProfileCurve middle, double z, double half, double rib, double thick) {
    int n = middle.size();
    Vector3d[] row = new Vector3d[2 * n];
    for (int i = 0; i < n; i++) {
      double dx = middle.x(Math.min(i + 1, n - 1)) - middle.x(Math.max(i - 1, 0));
      double dy = middle.y(Math.min(i + 1, n - 1)) - middle.y(Math.max(i - 1, 0));
      double length = Math.sqrt(dx * dx + dy * dy);
      double nx = i < 2 || i > n - 3 ? 0 : dy / length;
      double ny = i < 2 ? -1 : i > n - 3 ? 1 : -dx / length;
      double ribbed = half + (i > 2 && i < n - 3 ? rib : 0);
      row[i] = new Vector3d(middle.x(i) - ribbed * Math.abs(nx), middle.y(i) + ribbed * ny, z);
      row[2 * n - 1 - i] =
          new Vector3d(middle.x(i) + half * Math.abs(nx), middle.y(i) - half * ny, z);
    }
    return row;
  }

  /** Returns the height of the four raised bands across the spine at a row. */
  private static double rib(int row) {
    return row > 2 && row < ROWS - 2 && (row - 4) % 6 < 2 ? 0.0035 : 0;
  }

  /** Returns the pages, concave at the fore edge as the spine is convex. */
  private static TriangleMesh pages(Book book) {
    double low = COVER * 0.9;
    double high = book.thick - low;
    double right = book.width / 2 - 0.005;
    double left = 0.016 - book.width / 2;
    ProfileCurve block =
        ProfileCurve.from(left, low)
            .line(right, low)
            .bezier(right - 0.006, low + 0.3 * high, right - 0.006, 0.7 * high, right, high, 8)
            .line(left, high);
    return ExtrudedSolid.plain(book.length - 0.012, block.closed())
        .move(0, 0, 0.006 - book.length / 2);
  }
}
