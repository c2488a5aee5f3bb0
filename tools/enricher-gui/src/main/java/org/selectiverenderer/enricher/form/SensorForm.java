package org.selectiverenderer.enricher.form;

import java.util.List;
import java.util.function.UnaryOperator;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.document.DocumentElement;
import org.selectiverenderer.document.enrichment.SensorNode;
import org.selectiverenderer.enricher.help.HelpTexts;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.schema.SensorSchemas;

/** The form of a ProximitySensor: its schemas on entering and on leaving. */
final class SensorForm implements NodeForm {
  private final EnricherSession session;
  private final DocumentElement element;
  private final JPanel panel = new JPanel(new MigLayout("insets 4, gap 6, fillx", "[][grow]"));
  private final SchemaField enter;
  private final SchemaField exit;

  SensorForm(EnricherSession session, SensorNode node) {
    this.session = session;
    this.element = node.element();
    enter =
        new SchemaField(
            "Schemas on entering",
            HelpTexts.ENTER,
            session.enrichment()::schemas,
            wanted -> change(now -> new SensorSchemas(wanted, now.exit())));
    exit =
        new SchemaField(
            "Schemas on leaving",
            HelpTexts.EXIT,
            session.enrichment()::schemas,
            wanted -> change(now -> new SensorSchemas(now.enter(), wanted)));
    add("On entering", enter);
    add("On leaving", exit);
    show(node.schemas());
  }

  private void add(String text, SchemaField field) {
    JLabel label = new JLabel(text);
    label.setLabelFor(field.component());
    field.component().setEnabled(session.document().locked().isEmpty());
    panel.add(label, "alignx right");
    panel.add(field.component(), "growx, wmin 80, wrap");
  }

  private void change(UnaryOperator<SensorSchemas> change) {
    session
        .enrichment()
        .sensorNode(element)
        .ifPresent(
            node ->
                session.attempt(
                    () ->
                        session
                            .document()
                            .perform(session.edits().sensor(node, change.apply(node.schemas())))));
    refresh();
  }

  private void show(SensorSchemas schemas) {
    enter.show(List.copyOf(schemas.enter()));
    exit.show(List.copyOf(schemas.exit()));
  }

  @Override
  public boolean refresh() {
    var node = session.enrichment().sensorNode(element);
    node.ifPresent(now -> show(now.schemas()));
    return node.isPresent();
  }

  @Override
  public JPanel component() {
    return panel;
  }

  @Override
  public void commit() {
    enter.commit();
    exit.commit();
  }

  @Override
  public void dispose() {
    // nothing is under way
  }
}
