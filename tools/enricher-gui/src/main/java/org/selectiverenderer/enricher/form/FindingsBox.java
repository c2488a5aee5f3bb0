package org.selectiverenderer.enricher.form;

import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.document.ElementFinding;
import org.selectiverenderer.document.enrichment.EnrichedSensor;
import org.selectiverenderer.document.enrichment.EnrichedSwitch;
import org.selectiverenderer.enricher.problems.SeverityIcon;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.x3d.source.DocumentElement;

/** What is wrong with the selected node, each with the button that mends it. */
final class FindingsBox extends JPanel {
  private static final long serialVersionUID = 1L;

  private final transient EnricherSession session;
  private transient List<ElementFinding> shown = List.of();

  FindingsBox(EnricherSession session) {
    super(new MigLayout("insets 0, wrap 2, hidemode 3", "[][grow,fill]"));
    this.session = session;
    getAccessibleContext().setAccessibleName("Problems of this node");
  }

  /** Shows what is said of an element. */
  void show(Optional<DocumentElement> element) {
    List<ElementFinding> now = element.map(this::findings).orElse(List.of());
    if (same(now)) {
      shown = now;
      return;
    }
    shown = now;
    removeAll();
    for (int i = 0; i < now.size(); i++) {
      add(now.get(i), i);
    }
    setVisible(!now.isEmpty());
    revalidate();
    repaint();
  }

  private List<ElementFinding> findings(DocumentElement element) {
    List<ElementFinding> own =
        session
            .enrichment()
            .switchNode(element)
            .map(EnrichedSwitch::findings)
            .or(() -> session.enrichment().sensorNode(element).map(EnrichedSensor::findings))
            .orElse(List.of());
    return session.enrichment().findings().stream()
        .filter(finding -> finding.element() == element || own.contains(finding))
        .toList();
  }

  private boolean same(List<ElementFinding> now) {
    boolean same = now.size() == shown.size();
    for (int i = 0; same && i < now.size(); i++) {
      same =
          now.get(i).message().equals(shown.get(i).message())
              && now.get(i).element() == shown.get(i).element();
    }
    return same;
  }

  private void add(ElementFinding finding, int index) {
    add(SeverityIcon.label(finding.severity()), "aligny top");
    add(Labels.sentences(finding.message()), "wmin 0");
    finding
        .fix()
        .ifPresent(
            fix -> {
              JButton mend = new JButton(fix.name());
              mend.setName("Fix " + index);
              if (index == 0) {
                mend.setMnemonic('X');
              }
              mend.addActionListener(event -> mend(index));
              add(mend, "skip 1, growx 0, wmin 0");
            });
  }

  /** The finding that says so now: what it refers to is that of the newest text. */
  private void mend(int index) {
    shown
        .get(index)
        .fix()
        .ifPresent(fix -> session.attempt(() -> session.perform(fix.edit().get())));
  }
}
