package org.selectiverenderer.enricher.tree;

import com.formdev.flatlaf.ui.FlatUIUtils;
import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Graphics;
import java.util.Optional;
import java.util.function.Predicate;
import javax.swing.JTree;
import javax.swing.UIManager;
import javax.swing.tree.DefaultTreeCellRenderer;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.enrichment.EnrichedSensor;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.versions.ElementHints;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Renders a row of the tree: icon with a badge, type and name. Of an element without a name, a hint
 * of what is in it follows in gray.
 */
final class NodeTreeCellRenderer extends DefaultTreeCellRenderer {
  private static final long serialVersionUID = 1L;

  private final transient DocumentEnrichment enrichment;
  private final transient Predicate<DocumentElement> faulty;
  private final transient ElementHints hints;
  private String hint = "";

  NodeTreeCellRenderer(DocumentEnrichment enrichment, Predicate<DocumentElement> faulty) {
    this.enrichment = enrichment;
    this.faulty = faulty;
    this.hints = new ElementHints(enrichment.document());
    PlainText.only(this);
  }

  @Override
  public Component getTreeCellRendererComponent(
      JTree tree,
      Object value,
      boolean selected,
      boolean expanded,
      boolean leaf,
      int row,
      boolean focused) {
    super.getTreeCellRendererComponent(tree, value, selected, expanded, leaf, row, focused);
    hint = "";
    if (value instanceof DocumentElement element) {
      setText(text(element));
      hint =
          prototype(element).isPresent()
              ? "" // its text tells the prototype already
              : hints.of(element).map(NodeTreeCellRenderer::words).orElse("");
      setEnabled(element.attached());
      NodeIcon.Mark mark = mark(element);
      setIcon(new NodeIcon(NodeIcon.Kind.of(element.name()), mark));
      setToolTipText(
          switch (mark) {
            case NONE -> describable(element) && element.attached() ? Texts.of("nodes.bare") : null;
            case ENRICHED -> Texts.of("nodes.enriched");
            case FAULTY -> Texts.of("nodes.faulty");
          });
    }
    getAccessibleContext()
        .setAccessibleName(hint.isEmpty() ? null : getText() + ", " + hint); // null for the text
    return this;
  }

  private static String words(ElementHints.Hint hint) {
    return hint.polygons() == 0
        ? hint.content()
        : hint.content()
            + ", "
            + Texts.of(
                "counts.polygons", hint.polygons(), DecimalFormatter.grouped(hint.polygons()));
  }

  @Override
  public Dimension getPreferredSize() {
    Dimension size = super.getPreferredSize();
    return hint.isEmpty() || size == null
        ? size
        : new Dimension(size.width + hintGap() + width(hint), size.height);
  }

  private int hintGap() {
    return 2 * width(" ");
  }

  private int width(String text) {
    return getFontMetrics(getFont()).stringWidth(text);
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    super.paintComponent(graphics);
    if (!hint.isEmpty()) {
      Color before = graphics.getColor();
      Color gray = UIManager.getColor("Label.disabledForeground");
      graphics.setColor(selected ? getForeground() : gray);
      graphics.setFont(getFont());
      int icon = getIcon() == null ? 0 : getIcon().getIconWidth() + getIconTextGap();
      int left = getInsets().left + icon + width(getText()) + hintGap();
      int baseline = getBaseline(getWidth(), getHeight());
      FlatUIUtils.drawString(this, graphics, hint, left, baseline);
      graphics.setColor(before);
    }
  }

  private static boolean describable(DocumentElement element) {
    return element.name().equals("Switch") || element.name().equals("ProximitySensor");
  }

  static String text(DocumentElement element) {
    String name =
        element
            .def()
            .or(() -> element.use().map(use -> Texts.of("nodes.uses", use)))
            .or(() -> prototype(element))
            .orElse("");
    return name.isEmpty()
        ? element.name()
        : describable(element) ? name : element.name() + "  " + name;
  }

  /** Returns the name of the prototype that an element declares, or is an instance of. */
  private static Optional<String> prototype(DocumentElement element) {
    return switch (element.name()) {
      case "ProtoDeclare", "ExternProtoDeclare", "ProtoInstance" -> element.text("name");
      default -> Optional.empty();
    };
  }

  private NodeIcon.Mark mark(DocumentElement element) {
    if (!element.attached()) {
      return NodeIcon.Mark.NONE;
    }
    boolean wrong = faulty.test(element);
    boolean enriched = false;
    if (element.name().equals("Switch")) {
      enriched = enrichment.switchNode(element).filter(EnrichedSwitch::enriched).isPresent();
    } else if (element.name().equals("ProximitySensor")) {
      enriched = enrichment.sensorNode(element).filter(EnrichedSensor::enriched).isPresent();
    }
    return wrong ? NodeIcon.Mark.FAULTY : enriched ? NodeIcon.Mark.ENRICHED : NodeIcon.Mark.NONE;
  }
}
