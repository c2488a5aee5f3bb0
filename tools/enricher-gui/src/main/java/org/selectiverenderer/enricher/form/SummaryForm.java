package org.selectiverenderer.enricher.form;

import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Mnemonics;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The form of an element without metadata: its position in the document and what can be done with
 * it.
 */
final class SummaryForm implements Form {
  private final EnricherSession session;
  private final DocumentElement element;
  private final ElementSummary summary;
  private final JPanel panel = new JPanel(new MigLayout("insets 0, wrap 1", "[grow,fill]"));

  /**
   * @param makeVersions opens the versions dialog for an element
   */
  SummaryForm(
      EnricherSession session, DocumentElement element, Consumer<DocumentElement> makeVersions) {
    this.session = session;
    this.element = element;
    summary = summary();
    if (!summary.path().isEmpty()) {
      panel.add(LabelFactory.sentences(Texts.of("form.in", summary.path())), "wmin 0");
    }
    panel.add(LabelFactory.sentences(summary.advice()), "wmin 0");
    summary
        .formed()
        .ifPresent(
            formed -> {
              JButton go = Mnemonics.button("form.go", formed.toString());
              go.addActionListener(event -> session.select(formed, this));
              panel.add(go, "growx 0");
            });
    if (summary.versions()) {
      JButton make = Mnemonics.button("form.make");
      make.addActionListener(event -> makeVersions.accept(element));
      panel.add(make, "growx 0");
    }
  }

  private ElementSummary summary() {
    return ElementSummary.of(session.document(), session.catalogue(), element);
  }

  @Override
  public JComponent component() {
    return panel;
  }

  @Override
  public boolean fits() {
    return element.attached() && summary.equals(summary());
  }

  @Override
  public void follow() {
    // The summary has no state of its own; fits() compares all of it.
  }

  @Override
  public void commit() {
    // It has no input.
  }

  @Override
  public void dispose() {
    // It listens to nothing.
  }
}
