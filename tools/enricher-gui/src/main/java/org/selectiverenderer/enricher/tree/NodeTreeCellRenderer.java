package org.selectiverenderer.enricher.tree;

import java.awt.Component;
import java.util.Optional;
import java.util.function.Predicate;
import javax.swing.JTree;
import javax.swing.tree.DefaultTreeCellRenderer;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.enrichment.EnrichedSensor;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Renders a row of the tree: icon with a badge, type and name. */
final class NodeTreeCellRenderer extends DefaultTreeCellRenderer {
  private static final long serialVersionUID = 1L;

  private final transient DocumentEnrichment enrichment;
  private final transient Predicate<DocumentElement> faulty;

  NodeTreeCellRenderer(DocumentEnrichment enrichment, Predicate<DocumentElement> faulty) {
    this.enrichment = enrichment;
    this.faulty = faulty;
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
    if (value instanceof DocumentElement element) {
      setText(text(element));
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
    return this;
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
