package org.selectiverenderer.authoring.editing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.x3d.source.TextEdit;

/** Comments made and unmade. */
class CommentToggleTest {
  private static String toggled(String text, int from, int to) {
    return TextEdit.applied(CommentToggle.toggle(text, from, to, "c").changes(), text).toString();
  }

  @Test
  void aLineBecomesACommentAndBackByteForByte() {
    String text = "<a>\r\n  <b c='1'/>\r\n</a>";
    String commented = toggled(text, 5, 17);
    assertThat(commented).isEqualTo("<a>\r\n  <!-- <b c='1'/> -->\r\n</a>");
    assertThat(toggled(commented, 14, 14)).isEqualTo(text);
  }

  @Test
  void commentsWithinAreKept() {
    String text = "<a/><!-- one --><b/><!--two-->";
    String commented = toggled(text, 0, text.length());
    assertThat(commented).isEqualTo("<!-- <a/><!~~ one ~~><b/><!~~two~~> -->");
    assertThat(toggled(commented, 6, 6)).isEqualTo(text);
  }

  @Test
  void whatAnotherProgramCommentedIsFreed() {
    assertThat(toggled("<!--<a/>-->", 5, 5)).isEqualTo("<a/>");
  }

  @Test
  void hyphensAndNothingAreRefused() {
    assertThatThrownBy(() -> toggled("<a b='--'/>", 0, 11))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("hyphens");
    assertThatThrownBy(() -> toggled("<a/>\n\n", 5, 5)).isInstanceOf(EditRejectedException.class);
    assertThatThrownBy(() -> toggled("<!-- <a/>", 6, 6))
        .isInstanceOf(EditRejectedException.class)
        .hasMessageContaining("is not closed");
  }
}
