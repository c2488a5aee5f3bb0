package org.selectiverenderer.enricher.form;

import java.util.List;
import javax.swing.JComponent;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;

/** A form composed of other forms of one node, one below the other. */
record BothForms(JComponent component, List<Form> forms) implements Form {
  static BothForms of(Form... forms) {
    JPanel panel = new JPanel(new MigLayout("insets 0, gap 0, wrap 1", "[grow,fill]"));
    for (Form form : forms) {
      panel.add(form.component(), "wmin 0");
    }
    return new BothForms(panel, List.of(forms));
  }

  @Override
  public boolean fits() {
    return forms.stream().allMatch(Form::fits);
  }

  @Override
  public void follow() {
    forms.forEach(Form::follow);
  }

  @Override
  public void commit() {
    forms.forEach(Form::commit);
  }

  @Override
  public void dispose() {
    forms.forEach(Form::dispose);
  }
}
