package org.selectiverenderer.enricher.plan;

import java.awt.AlphaComposite;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Composite;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.UIManager;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.area.AreaInstance;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.area.FloorPlanImage;
import org.selectiverenderer.enricher.component.AccessibleCanvas;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The component that paints the plan: the image below the cut, walls, areas, and the rectangle
 * being drawn.
 */
final class FloorPlanCanvas extends AccessibleCanvas {
  private static final long serialVersionUID = 1L;

  /** The colours of the plan itself in a theme. */
  private record Colours(Color paper, Color wall, Color grid, float image) {
    static final Colours LIGHT =
        new Colours(new Color(0xf4f2ee), new Color(0x303030), new Color(0, 0, 0, 24), 1);
    static final Colours DARK =
        new Colours(new Color(0x26282b), new Color(0xe8e6e0), new Color(255, 255, 255, 22), 0.55f);

    static Colours now() {
      Color ground = UIManager.getColor("Panel.background");
      boolean dark =
          ground != null && ground.getRed() + ground.getGreen() + ground.getBlue() < 3 * 128;
      return dark ? DARK : LIGHT;
    }
  }

  private static final Color AREA = new Color(0x1a6fd0);
  private static final Color SELECTED = new Color(0xd86f00);
  private static final int GRIP = 4;

  /** Least distance in pixels between grid lines. */
  private static final double CLOSEST = 7;

  private final transient Supplier<List<AreaInstance>> areas;
  private final transient Supplier<Optional<DocumentElement>> selection;
  private transient Consumer<Graphics2D> overlay = graphics -> {};
  private transient @Nullable FloorPlanImage picture;
  private transient @Nullable PlanTransform scale;

  /**
   * The component size for which the plan was fitted; null once the author has zoomed or panned.
   */
  private transient @Nullable Dimension fitted;

  private transient @Nullable BoundingBox drawn;
  private transient @Nullable AreaInstance moved;
  private double grid;

  FloorPlanCanvas(
      Supplier<List<AreaInstance>> areas, Supplier<Optional<DocumentElement>> selection) {
    super(Texts.of("area.plan"));
    this.areas = areas;
    this.selection = selection;
    setName("Plan");
    getAccessibleContext().setAccessibleDescription(Texts.of("area.plan.empty"));
  }

  void show(FloorPlanImage of) {
    if (picture == null || !near(picture.extent(), of.extent())) {
      scale = null; // another scene or much more of it
    }
    picture = of;
    getAccessibleContext().setAccessibleDescription("");
    repaint();
  }

  private static boolean near(BoundingBox a, BoundingBox b) {
    double some = 0.25 * Math.max(a.extent(), b.extent());
    return Math.abs(a.minX() - b.minX()) < some
        && Math.abs(a.minZ() - b.minZ()) < some
        && Math.abs(a.maxX() - b.maxX()) < some
        && Math.abs(a.maxZ() - b.maxZ()) < some;
  }

  Optional<FloorPlanImage> picture() {
    return Optional.ofNullable(picture);
  }

  /** Shows a grid of a step in metres; 0 for none. */
  void grid(double step) {
    grid = step;
    repaint();
  }

  /** Sets what is painted over the plan. */
  void overlay(Consumer<Graphics2D> painter) {
    overlay = painter;
  }

  /** Shows a part of the scene. */
  void fit(BoundingBox part) {
    scale(
        PlanTransform.fitting(
            part.grown(0.25 * Math.max(0.5, part.extent())),
            Math.max(1, getWidth()),
            Math.max(1, getHeight())));
  }

  void fit() {
    scale = null;
    repaint();
  }

  PlanTransform scale() {
    PlanTransform now = scale;
    if (now == null || fitted != null && !fitted.equals(getSize())) {
      BoundingBox all =
          picture().map(FloorPlanImage::extent).orElse(new BoundingBox(-5, 0, -5, 5, 0, 5));
      now = PlanTransform.fitting(all, Math.max(1, getWidth()), Math.max(1, getHeight()));
      if (picture != null && getWidth() > 0) {
        scale = now;
        fitted = getSize();
      }
    }
    return now;
  }

  void scale(PlanTransform now) {
    scale = now;
    fitted = null;
    repaint();
  }

  /**
   * Shows a rectangle that is being drawn or an area that is being changed.
   *
   * @param rectangle null for none
   * @param of the area being changed; null for a new one
   */
  void drawing(@Nullable BoundingBox rectangle, @Nullable AreaInstance of) {
    drawn = rectangle;
    moved = of;
    repaint();
  }

  Optional<BoundingBox> drawing() {
    return Optional.ofNullable(drawn);
  }

  /** The areas in hit-test order: the selected one first, then from the smallest to the largest. */
  List<AreaInstance> hitOrder() {
    List<AreaInstance> all = new ArrayList<>(areas.get());
    all.sort(
        (a, b) ->
            selected(a) != selected(b)
                ? Boolean.compare(selected(b), selected(a))
                : Double.compare(ground(a), ground(b)));
    return all;
  }

  private static double ground(AreaInstance area) {
    BoundingBox bounds = bounds(area);
    return bounds.width() * bounds.depth();
  }

  boolean selected(AreaInstance area) {
    return selection.get().filter(element -> element == area.element()).isPresent();
  }

  Optional<AreaInstance> selected() {
    return areas.get().stream().filter(this::selected).findFirst();
  }

  /** The axis-aligned bounds of an area in world coordinates. */
  static BoundingBox bounds(AreaInstance area) {
    return area.solid().map(solid -> solid.bounds()).orElse(area.box().bounds());
  }

  /** Returns a resize handle of a rectangle; sides are -1, 0 or 1 for each axis. */
  static Rectangle2D grip(Rectangle2D of, int sideX, int sideZ) {
    double x = of.getCenterX() + sideX * of.getWidth() / 2;
    double y = of.getCenterY() + sideZ * of.getHeight() / 2;
    return new Rectangle2D.Double(x - GRIP, y - GRIP, 2 * GRIP, 2 * GRIP);
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    Graphics2D g = (Graphics2D) graphics.create();
    Colours colours = Colours.now();
    g.setColor(colours.paper());
    g.fillRect(0, 0, getWidth(), getHeight());
    PlanTransform at = scale();
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    g.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    g.setRenderingHint(
        RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
    picture().ifPresent(plan -> paint(g, at, plan, colours));
    paintGrid(g, at, colours.grid());
    areas.get().stream().filter(area -> !selected(area)).forEach(area -> paint(g, at, area));
    selected().ifPresent(area -> paint(g, at, area));
    BoundingBox now = drawn;
    if (now != null) {
      outline(g, at.rectangle(now), SELECTED, true);
      String name = moved == null ? Texts.of("area.add.title") : moved.name();
      label(g, at.rectangle(now), says(name, now.width(), now.depth()), SELECTED);
    }
    if (picture == null) {
      g.setColor(colours.wall());
      g.drawString(Texts.of("area.plan.empty"), 16, 24);
    }
    overlay.accept(g);
    if (picture != null) {
      ScaleBar.of(at.scale()).paint(g, getHeight(), colours.wall(), colours.paper());
    }
    if (isFocusOwner()) {
      Color focus = UIManager.getColor("Component.focusColor");
      g.setColor(focus == null ? Color.BLUE : focus);
      g.setStroke(new BasicStroke(2));
      g.drawRect(1, 1, getWidth() - 2, getHeight() - 2);
    }
    g.dispose();
  }

  private static void paint(Graphics2D g, PlanTransform at, FloorPlanImage plan, Colours colours) {
    BoundingBox extent = plan.extent();
    Rectangle2D place = at.rectangle(extent);
    AffineTransform to = AffineTransform.getTranslateInstance(place.getMinX(), place.getMinY());
    double pixel =
        Math.max(extent.width(), extent.depth())
            * at.scale()
            / Math.max(plan.image().getWidth(), plan.image().getHeight());
    to.scale(pixel, pixel);
    Composite whole = g.getComposite();
    g.setComposite(AlphaComposite.SrcOver.derive(colours.image()));
    g.drawImage(plan.image(), to, null);
    g.setComposite(whole);
    g.setColor(colours.wall());
    g.setStroke(new BasicStroke(1.6f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    float[] walls = plan.walls();
    Path2D.Float lines = new Path2D.Float();
    for (int i = 0; i + 3 < walls.length; i += 4) {
      lines.moveTo(at.toX(walls[i]), at.toY(walls[i + 1]));
      lines.lineTo(at.toX(walls[i + 2]), at.toY(walls[i + 3]));
    }
    g.draw(lines);
  }

  private void paintGrid(Graphics2D g, PlanTransform at, Color colour) {
    double step = grid;
    while (step > 0 && step * at.scale() < CLOSEST) {
      step *= step * at.scale() * 5 < CLOSEST ? 10 : 5;
    }
    if (step <= 0) {
      return;
    }
    g.setColor(colour);
    g.setStroke(new BasicStroke(1));
    for (double x = Math.ceil(at.x(0) / step) * step; at.toX(x) < getWidth(); x += step) {
      g.draw(new Line2D.Double(at.toX(x), 0, at.toX(x), getHeight()));
    }
    for (double z = Math.ceil(at.z(0) / step) * step; at.toY(z) < getHeight(); z += step) {
      g.draw(new Line2D.Double(0, at.toY(z), getWidth(), at.toY(z)));
    }
  }

  private void paint(Graphics2D g, PlanTransform at, AreaInstance area) {
    boolean selected = selected(area);
    boolean busy = moved != null && moved.element() == area.element();
    Color colour = selected ? SELECTED : AREA;
    Rectangle2D place = at.rectangle(bounds(area));
    if (area.frame().turned() && area.solid().isPresent()) {
      g.setColor(new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), 60));
      g.setStroke(new BasicStroke(1.5f));
      List<Vector3dc> corners = area.solid().get().corners();
      for (int[] edge :
          new int[][] {{0, 1}, {1, 5}, {5, 4}, {4, 0}, {2, 3}, {3, 7}, {7, 6}, {6, 2}}) {
        Vector3dc a = corners.get(edge[0]);
        Vector3dc b = corners.get(edge[1]);
        g.setColor(colour);
        g.draw(new Line2D.Double(at.toX(a.x()), at.toY(a.z()), at.toX(b.x()), at.toY(b.z())));
      }
    } else {
      outline(g, place, colour, busy);
    }
    if (!busy) {
      label(g, place, says(area.name(), bounds(area).width(), bounds(area).depth()), colour);
      if (selected && !area.frame().turned()) {
        for (int sideX = -1; sideX <= 1; sideX++) {
          for (int sideZ = -1; sideZ <= 1; sideZ++) {
            if (sideX != 0 || sideZ != 0) {
              Rectangle2D grip = grip(place, sideX, sideZ);
              g.setColor(Color.WHITE);
              g.fill(grip);
              g.setColor(SELECTED);
              g.draw(grip);
            }
          }
        }
      }
    }
  }

  private static String says(String name, double width, double depth) {
    return Texts.of(
        "area.plan.area", name, DecimalFormatter.fixed(width, 2), DecimalFormatter.fixed(depth, 2));
  }

  private static void outline(Graphics2D g, Rectangle2D place, Color colour, boolean faint) {
    int alpha = faint ? 25 : 45;
    g.setColor(new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), alpha));
    g.fill(place);
    g.setColor(colour);
    g.setStroke(
        faint
            ? new BasicStroke(
                1.5f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 10, new float[] {5, 4}, 0)
            : new BasicStroke(2));
    g.draw(place);
  }

  private static void label(Graphics2D g, Rectangle2D place, String text, Color colour) {
    FontMetrics metrics = g.getFontMetrics();
    int width = metrics.stringWidth(text) + 8;
    int left = (int) (place.getMinX() + 3);
    int top = (int) (place.getMinY() + 3);
    g.setColor(colour);
    g.fillRoundRect(left, top, width, metrics.getHeight() + 2, 4, 4);
    g.setColor(Color.WHITE);
    g.drawString(text, left + 4, top + 1 + metrics.getAscent());
  }
}
