package org.selectiverenderer.enricher.diff;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.document.file.LineMerge;
import org.selectiverenderer.document.file.LineMerge.Choice;
import org.selectiverenderer.enricher.driving.Hands;
import org.selectiverenderer.enricher.driving.Sessions;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.testing.ShowsWindows;

@ShowsWindows
class MergeDialogTest {
  private static final String BASE =
      "<X3D version='4.0'>\n<Scene>\n  <Shape DEF='Cup'/>\n  <Shape DEF='Pot'/>\n</Scene>\n</X3D>\n";

  private final LineMerge merge =
      LineMerge.of(
          Optional.of(BASE),
          BASE.replace("'Cup'", "'Mug'").replace("</X3D>", "</X3D><!-- mine -->"),
          BASE.replace("'Cup'", "'Glass'").replace("4.0", "3.3"));

  @Test
  void conflictsAreDecidedOneAfterTheOther() throws Exception {
    Sessions.theme(false);
    Hands hands = new Hands();
    MergeDialog dialog = Hands.onEdt(() -> new MergeDialog(null, merge));
    hands.show(dialog);
    JButton all = button(dialog, "apply");
    assertThat(Hands.onEdt(all::isEnabled)).as("something is undecided").isFalse();
    hands.click(button(dialog, "mine.first"));
    hands.await("all decided", all::isEnabled);
    Hands.picture(dialog.getContentPane(), "merge", 1);
    hands.click(all);
    hands.await("the end", () -> !dialog.isShowing());
    assertThat(Hands.onEdt(dialog::choices)).contains(List.of(Choice.MINE_FIRST));
    assertThat(merge.text(List.of(Choice.MINE_FIRST)))
        .contains("3.3", "'Mug'", "'Glass'", "<!-- mine -->");
  }

  private static JButton button(MergeDialog dialog, String key) {
    return Hands.named(dialog, Texts.of("merge." + key), JButton.class);
  }
}
