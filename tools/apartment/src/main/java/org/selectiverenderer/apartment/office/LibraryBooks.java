package org.selectiverenderer.apartment.office;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;

/**
 * Rows of books in the bays of the {@link Bookcase}, the same at every call. The model's y = 0 is
 * the shelf that the lowest books stand on, {@link #LOWEST_SHELF}; x and z are the bookcase's
 * (thesis Fig 71).
 */
final class LibraryBooks {
  /** The shelf that the model stands on. */
  static final int LOWEST_SHELF = 0;

  /** Shelf, side (-1 left, 1 right), and share of the bay that is filled. */
  private static final double[][] ROWS = {
    {4, -1, 1.0}, {4, 1, 0.66}, {3, -1, 0.72}, {1, 1, 0.5}, {0, 1, 0.62}
  };

  private static final List<ModelMaterial> COVERS =
      List.of(
          cover(0.45, 0.11, 0.1),
          cover(0.13, 0.24, 0.4),
          cover(0.15, 0.32, 0.22),
          cover(0.62, 0.42, 0.18),
          cover(0.3, 0.2, 0.13),
          cover(0.7, 0.66, 0.56));

  private final Random random = new Random(1932);
  private final List<List<TriangleMesh>> covers = new ArrayList<>();
  private final List<TriangleMesh> pages = new ArrayList<>();
  private final List<TriangleMesh> labels = new ArrayList<>();
  private int last;

  private LibraryBooks() {
    COVERS.forEach(look -> covers.add(new ArrayList<>()));
  }

  static ParametricModel model() {
    LibraryBooks books = new LibraryBooks();
    for (double[] row : ROWS) {
      books.fill((int) row[0], (int) row[1], row[2]);
    }
    List<Part> parts = new ArrayList<>();
    for (int i = 0; i < COVERS.size(); i++) {
      parts.add(Part.of("covers" + (i + 1), COVERS.get(i), TriangleMesh.of(books.covers.get(i))));
    }
    parts.add(Part.of("pages", Materials.PAPER, TriangleMesh.of(books.pages)));
    ModelMaterial gold = ModelMaterial.satin(ModelColour.of(0.85, 0.72, 0.4));
    parts.add(Part.of("labels", gold, TriangleMesh.of(books.labels)));
    return new ParametricModel("libraryBooks", parts);
  }

  private static ModelMaterial cover(double red, double green, double blue) {
    return ModelMaterial.satin(ModelColour.of(red, green, blue));
  }

  /**
   * Fills a bay from the outer wall towards the post; the last book leans unless the bay is full.
   */
  private void fill(int shelf, int side, double part) {
    double wall = BookcaseDimensions.WIDTH / 2 - BookcaseDimensions.BOARD;
    double at = 0;
    double end = part * BookcaseDimensions.BAY;
    while (at < end - 0.03) {
      double left = end - at;
      double thick = Math.min(left, 0.038 + 0.036 * random.nextDouble());
      if (left - thick < 0.03) {
        thick = Math.min(left, 0.07);
      }
      double height = 0.22 + 0.1 * random.nextDouble();
      Book book = new Book(thick - 0.001, height, 0.17 + 0.05 * random.nextDouble());
      at += thick;
      double middle = at - thick / 2;
      boolean leans = part < 1 && at >= end - 0.03;
      double y = BookcaseDimensions.top(shelf) - BookcaseDimensions.top(LOWEST_SHELF);
      place(book, side * (wall - middle), y, leans ? side : 0);
    }
  }

  private void place(Book book, double x, double y, int leaningTo) {
    int colour = random.nextInt(COVERS.size() - 1);
    last = colour >= last ? colour + 1 : colour;
    covers.get(last).add(stand(book.cover(), book, x, y, leaningTo));
    pages.add(stand(book.pages(), book, x, y, leaningTo));
    labels.add(stand(book.label(), book, x, y, leaningTo));
  }

  private static TriangleMesh stand(
      TriangleMesh mesh, Book book, double x, double y, int leaningTo) {
    TriangleMesh placed = mesh;
    if (leaningTo != 0) {
      // Rotates the book about its lower edge on the side of the others, then moves it away by the
      // overhang of its upper edge.
      double lean = -leaningTo * 9.0;
      double edge = leaningTo * book.thick() / 2;
      placed =
          mesh.move(-edge, 0, 0)
              .turnZ(lean)
              .move(edge - leaningTo * book.height() * DegreeMath.sin(9), 0, 0);
    }
    return placed.move(x, y, 0.11 - book.deep() / 2);
  }
}
