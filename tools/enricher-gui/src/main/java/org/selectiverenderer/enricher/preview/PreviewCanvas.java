package org.selectiverenderer.enricher.preview;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.compare.ComparisonPainter;
import org.selectiverenderer.enricher.component.AccessibleCanvas;
import org.selectiverenderer.enricher.text.Texts;

/**
 * Shows preview frames with labels and lines of text. The picture has device pixels; {@link
 * #toPixels} converts positions of this component to them.
 */
final class PreviewCanvas extends AccessibleCanvas {
  private static final long serialVersionUID = 1L;
  private static final Color PAPER = new Color(0, 0, 0, 150);
  private static final Color PAPER_SELECTED = new Color(150, 80, 0, 200);

  /** Background of labels of areas behind walls, translucent. */
  private static final Color PAPER_HIDDEN = new Color(0, 0, 0, 60);

  private static final Color INK_HIDDEN = new Color(255, 255, 255, 140);
  private static final int PAD = 4;

  private record Shown(Rectangle place, PreviewFrame.Label label) {}

  private transient @Nullable PreviewFrame frame;
  private transient List<Shown> shown = List.of();
  private final transient List<BiConsumer<Graphics2D, PreviewFrame>> overlays = new ArrayList<>();
  private final transient ComparisonPainter comparison = new ComparisonPainter();

  private final FirstPicturePane waiting = new FirstPicturePane();

  PreviewCanvas() {
    super(Texts.of("preview.picture"));
    setLayout(new MigLayout("fill, insets 0, hidemode 3", "[center]", "[center]"));
    add(waiting, "wmin 0");
  }

  /** The sentence that is shown until there is a picture. */
  FirstPicturePane waiting() {
    return waiting;
  }

  void show(PreviewFrame newFrame) {
    frame = newFrame;
    waiting.setVisible(false);
    getAccessibleContext().setAccessibleDescription(String.join(". ", lines(newFrame)));
    repaint();
  }

  /** Adds what is painted over every picture. */
  void overlay(BiConsumer<Graphics2D, PreviewFrame> painter) {
    overlays.add(painter);
  }

  Optional<PreviewFrame> frame() {
    return Optional.ofNullable(frame);
  }

  /** Device pixels per unit of this component. */
  double scale() {
    return getGraphicsConfiguration() == null
        ? 1
        : getGraphicsConfiguration().getDefaultTransform().getScaleX();
  }

  int toPixels(int position) {
    return (int) Math.round(position * scale());
  }

  /** The left edge of the preview's own picture, beside which a reference image may be. */
  int left() {
    return ComparisonPainter.offset(frame().flatMap(PreviewFrame::compared), getWidth());
  }

  /** Where the preview's own picture begins to be seen, of which labels and lines of text tell. */
  private int ownEdge() {
    return comparison.ownEdge(frame().flatMap(PreviewFrame::compared), getWidth());
  }

  /** The painter of comparisons. */
  ComparisonPainter comparison() {
    return comparison;
  }

  /** Whether a mouse press at a position grabs the line of a comparison. */
  boolean takesLine(int x) {
    return comparison.takes(frame().flatMap(PreviewFrame::compared), x, getWidth());
  }

  /** Sets the position of that line, as a share of the width. */
  void line(double part) {
    comparison.line(part);
    repaint();
  }

  /** The label at a position. */
  Optional<PreviewFrame.Label> labelAt(int x, int y) {
    return shown.stream()
        .filter(label -> x >= ownEdge() && label.place().contains(x, y))
        .map(Shown::label)
        .findFirst();
  }

  /** Returns the lines of text in the lower left corner. */
  static List<String> lines(PreviewFrame frame) {
    List<String> lines = new ArrayList<>();
    if (frame.walking()) {
      lines.add(Texts.of("preview.walking", list(frame.areas())));
      lines.add(Texts.of("preview.active", list(frame.schemas())));
    } else if (!frame.schemas().isEmpty()) {
      lines.add(Texts.of("preview.asif.one", list(frame.schemas())));
    }
    frame.version().ifPresent(lines::add);
    lines.add(
        Texts.of(
            "counts.polygonsdrawn",
            frame.polygons(),
            DecimalFormatter.grouped(frame.polygons()),
            DecimalFormatter.grouped(frame.drawn())));
    lines.add(Texts.of("counts.drawnin", DecimalFormatter.fixed(frame.milliseconds(), 1)));
    return lines;
  }

  private static String list(List<String> names) {
    return names.isEmpty() ? Texts.of("preview.nonames") : String.join(", ", names);
  }

  static String text(PreviewFrame.Label label) {
    StringBuilder text = new StringBuilder(label.name());
    if (!label.schemas().enter().isEmpty()) {
      text.append("  \u2192 ").append(String.join(", ", label.schemas().enter()));
    }
    if (!label.schemas().exit().isEmpty()) {
      text.append("  \u2190 ").append(String.join(", ", label.schemas().exit()));
    }
    label
        .polygons()
        .ifPresent(
            count ->
                text.append("  (")
                    .append(Texts.of("counts.inarea", count, DecimalFormatter.grouped(count)))
                    .append(')'));
    return text.toString();
  }

  @Override
  protected void paintComponent(Graphics g) {
    Graphics2D g2 = (Graphics2D) g.create();
    Color ground = UIManager.getColor("Panel.background");
    g2.setColor(ground == null ? Color.DARK_GRAY : ground);
    g2.fillRect(0, 0, getWidth(), getHeight());
    if (frame != null) {
      double scale = scale();
      if (frame.compared().isPresent()) {
        comparison.paint(
            g2,
            frame.compared().get(),
            frame.image(),
            frame.polygons(),
            scale,
            getWidth(),
            getHeight());
      } else {
        g2.drawImage(frame.image(), AffineTransform.getScaleInstance(1 / scale, 1 / scale), null);
      }
      g2.setRenderingHint(
          RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
      Graphics2D own = (Graphics2D) g2.create();
      own.clipRect(ownEdge(), 0, getWidth(), getHeight());
      paintLabels(own, frame, scale);
      paintLines(own, lines(frame));
      own.dispose();
      for (BiConsumer<Graphics2D, PreviewFrame> overlay : overlays) {
        overlay.accept(g2, frame);
      }
    }
    if (isFocusOwner()) {
      Color focus = UIManager.getColor("Component.focusColor");
      g2.setColor(focus == null ? Color.BLUE : focus);
      g2.setStroke(new BasicStroke(2));
      g2.drawRect(1, 1, getWidth() - 2, getHeight() - 2);
    }
    g2.dispose();
  }

  /** Paints the labels, the selected one last and over the others. */
  private void paintLabels(Graphics2D g, PreviewFrame of, double scale) {
    FontMetrics metrics = g.getFontMetrics();
    List<Shown> all = new ArrayList<>();
    int moved = left();
    List<PreviewFrame.Label> seenFirst = new ArrayList<>(of.labels());
    seenFirst.sort(Comparator.comparing(PreviewFrame.Label::hidden));
    for (PreviewFrame.Label label : seenFirst) {
      int width = metrics.stringWidth(text(label)) + 2 * PAD;
      int height = metrics.getHeight() + PAD;
      Rectangle place =
          new Rectangle(
              Math.max(
                  moved,
                  Math.min(getWidth() - width, (int) (label.x() / scale) + moved - width / 2)),
              (int) (label.y() / scale) - height,
              width,
              height);
      while (covered(place, all)) {
        place.y += height;
      }
      Shown here = new Shown(place, label);
      all.add(label.selected() ? 0 : all.size(), here);
    }
    for (int i = all.size() - 1; i >= 0; i--) {
      Rectangle place = all.get(i).place();
      boolean faded = all.get(i).label().hidden() && !all.get(i).label().selected();
      g.setColor(faded ? PAPER_HIDDEN : all.get(i).label().selected() ? PAPER_SELECTED : PAPER);
      g.fillRoundRect(place.x, place.y, place.width, place.height, PAD, PAD);
      g.setColor(faded ? INK_HIDDEN : Color.WHITE);
      g.drawString(
          text(all.get(i).label()), place.x + PAD, place.y + PAD / 2 + metrics.getAscent());
    }
    shown = all;
  }

  private static boolean covered(Rectangle place, List<Shown> labels) {
    for (Shown label : labels) { // No stream: a large scene has tens of thousands of such pairs.
      if (label.place().intersects(place)) {
        return true;
      }
    }
    return false;
  }

  private void paintLines(Graphics2D g, List<String> lines) {
    FontMetrics metrics = g.getFontMetrics();
    int width = lines.stream().mapToInt(metrics::stringWidth).max().orElse(0) + 2 * PAD;
    int height = lines.size() * metrics.getHeight() + PAD;
    int top = getHeight() - height - PAD;
    int left = ownEdge() + PAD;
    g.setColor(PAPER);
    g.fillRoundRect(left, top, width, height, PAD, PAD);
    g.setColor(Color.WHITE);
    for (int i = 0; i < lines.size(); i++) {
      g.drawString(
          lines.get(i), left + PAD, top + PAD / 2 + metrics.getAscent() + i * metrics.getHeight());
    }
  }
}
