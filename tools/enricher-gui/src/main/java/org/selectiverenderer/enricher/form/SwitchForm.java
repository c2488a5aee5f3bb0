package org.selectiverenderer.enricher.form;

import java.util.ArrayList;
import java.util.List;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.document.DocumentElement;
import org.selectiverenderer.document.enrichment.ChoiceValues;
import org.selectiverenderer.document.enrichment.SwitchNode;
import org.selectiverenderer.enricher.session.EnricherSession;

/** The form of a Switch: a row per choice. */
final class SwitchForm implements NodeForm {
  private final EnricherSession session;
  private final DocumentElement element;
  private final JPanel panel = new JPanel(new MigLayout("insets 0, gap 8, fillx, wrap", "[grow]"));
  private final List<ChoiceRow> rows = new ArrayList<>();
  private final List<Runnable> requests = new ArrayList<>();

  SwitchForm(EnricherSession session, SwitchNode node, VersionImages images) {
    this.session = session;
    this.element = node.element();
    boolean editable = session.document().locked().isEmpty();
    for (SwitchNode.ChoiceNode choice : node.choices()) {
      ChoiceRow row =
          new ChoiceRow(
              choice.index(),
              session.enrichment()::schemas,
              editable,
              values -> change(choice.index(), values));
      rows.add(row);
      panel.add(row.component(), "growx, wmin 0");
    }
    show(node);
    for (SwitchNode.ChoiceNode choice : node.choices()) {
      ChoiceRow row = rows.get(choice.index());
      requests.add(images.request(node, choice, row::show, row::showLack));
    }
  }

  private void change(int index, ChoiceValues values) {
    session
        .enrichment()
        .switchNode(element)
        .ifPresent(
            node ->
                session.attempt(
                    () -> session.document().perform(session.edits().choice(node, index, values))));
    refresh();
  }

  private void show(SwitchNode node) {
    for (SwitchNode.ChoiceNode choice : node.choices()) {
      rows.get(choice.index()).show(choice, choice.index() == node.whichChoice());
    }
  }

  @Override
  public boolean refresh() {
    return session
        .enrichment()
        .switchNode(element)
        .filter(node -> node.choices().size() == rows.size())
        .map(
            node -> {
              show(node);
              return true;
            })
        .orElse(false);
  }

  @Override
  public JPanel component() {
    return panel;
  }

  @Override
  public void commit() {
    rows.forEach(ChoiceRow::commit);
  }

  @Override
  public void dispose() {
    requests.forEach(Runnable::run);
  }
}
