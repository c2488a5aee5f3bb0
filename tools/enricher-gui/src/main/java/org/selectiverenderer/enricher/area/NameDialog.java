package org.selectiverenderer.enricher.area;

import java.awt.Component;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import org.selectiverenderer.enricher.component.InputDialog;
import org.selectiverenderer.enricher.text.Texts;

/** Asks for a node name in a dialog beside the view that shows the node. */
public final class NameDialog implements NamePrompt {
  private final Supplier<Component> owner;

  /**
   * @param owner the view beside which the dialog opens
   */
  public NameDialog(Supplier<Component> owner) {
    this.owner = owner;
  }

  @Override
  public Optional<String> ask(
      String title, String proposal, Function<String, Optional<String>> complaint) {
    return InputDialog.askBeside(owner.get(), title, Texts.of("area.name"), proposal, complaint);
  }
}
