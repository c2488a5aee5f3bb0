package org.selectiverenderer.enricher.run;

import java.awt.Component;
import java.util.Optional;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.enricher.component.InputDialog;
import org.selectiverenderer.enricher.text.Texts;

/** Asks for the options of a run. */
public final class RunDialog {
  private RunDialog() {}

  /**
   * Shows the dialog and waits.
   *
   * @param before the options of the last run
   * @return empty if the author cancels
   */
  public static Optional<RunOptions> ask(Component over, RunOptions before) {
    JComboBox<String> condition = new JComboBox<>(RunOptions.CONDITIONS.toArray(String[]::new));
    condition.setSelectedItem(before.condition());
    condition.setName("run.condition");
    condition.getAccessibleContext().setAccessibleName(Texts.of("run.condition"));
    condition.setToolTipText(Texts.of("run.conditiontip"));
    JCheckBox here = new JCheckBox(Texts.of("run.here"), before.fromHere());
    here.setName("run.here");
    JPanel panel = new JPanel(new MigLayout("insets 0, wrap 2", "[][grow,fill]"));
    panel.add(new JLabel(Texts.of("run.condition")));
    panel.add(condition);
    panel.add(here, "span");
    panel.add(new JLabel(Texts.of("run.note")), "span");
    return new InputDialog(over, Texts.of("run.title"), panel, condition).ask(Optional::empty)
        ? Optional.of(
            new RunOptions(String.valueOf(condition.getSelectedItem()), here.isSelected()))
        : Optional.empty();
  }
}
