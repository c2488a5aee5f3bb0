package org.selectiverenderer.enricher.form;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSeparator;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.enrichment.EnrichedSensor;
import org.selectiverenderer.enricher.area.NodeCommands;
import org.selectiverenderer.enricher.help.HelpTopic;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Mnemonics;
import org.selectiverenderer.enricher.text.Texts;

/** The form of a ProximitySensor (thesis Fig 47): its name, its schemas and its box. */
final class SensorForm implements Form {
  private final EnricherSession session;
  private final EnrichedSensor node;
  private final JPanel panel =
      new JPanel(new MigLayout("insets 0, wrap 1, hidemode 3", "[grow,fill]"));
  private final List<FieldBinding> fields = new ArrayList<>();
  private final NodeCommands nodes;
  private final AreaBoxEditor box;
  private final boolean placed;

  SensorForm(EnricherSession session, EnrichedSensor node) {
    this.session = session;
    this.node = node;
    NodeCommands nodes = new NodeCommands(session);
    NameFieldRow name = new NameFieldRow(session, nodes, node.element());
    box = new AreaBoxEditor(session, nodes, node.element());
    placed = nodes.area(node.element()).isPresent();
    this.nodes = nodes;
    fields.add(name.field());
    fields.addAll(box.fields());
    panel.add(name.component(), "wmin 0");
    SensorFormModel editing = new SensorFormModel(session, node.element());
    add("form.enter", "enterTimeSchema", HelpTopic.ENTER, editing::enter, editing::enter);
    add("form.exit", "exitTimeSchema", HelpTopic.EXIT, editing::exit, editing::exit);
    panel.add(new JSeparator());
    panel.add(box.component(), "wmin 0");
  }

  private void add(
      String key,
      String name,
      HelpTopic topic,
      Supplier<String> read,
      Function<String, Optional<String>> write) {
    SchemaListField schemas = new SchemaListField(() -> session.enrichment().schemas());
    String lettered = Texts.of(key);
    String title = Mnemonics.without(lettered);
    schemas.setName(title);
    schemas
        .getAccessibleContext()
        .setAccessibleName(Texts.of("form.schemas", title.toLowerCase(Locale.ROOT)));
    schemas.putClientProperty("JTextField.placeholderText", Texts.of("form.commas"));
    schemas.setEditable(session.document().locked().isEmpty());
    topic.explain(schemas);
    JLabel label = LabelFactory.of(title + "  (" + name + ")", schemas, name);
    label.setDisplayedMnemonic(Mnemonics.code(lettered));
    JLabel complaint = LabelFactory.complaint();
    panel.add(label);
    panel.add(schemas, "wmin 0");
    panel.add(LabelFactory.room(complaint), "wmin 0, hmin pref");
    fields.add(FieldBinding.of(schemas, complaint, new FieldBinding.Source(read, write)));
  }

  @Override
  public JComponent component() {
    return panel;
  }

  @Override
  public boolean fits() {
    return session.enrichment().sensorNode(node.element()).isPresent()
        && nodes.area(node.element()).isPresent() == placed;
  }

  @Override
  public void follow() {
    fields.forEach(FieldBinding::follow);
    box.follow();
  }

  @Override
  public void commit() {
    fields.forEach(FieldBinding::commit);
  }

  @Override
  public void dispose() {
    fields.forEach(FieldBinding::close);
  }
}
