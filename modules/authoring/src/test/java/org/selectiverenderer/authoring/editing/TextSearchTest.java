package org.selectiverenderer.authoring.editing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.editing.TextSearch.BadSearch;
import org.selectiverenderer.authoring.editing.TextSearch.Hit;
import org.selectiverenderer.authoring.editing.TextSearch.Wanted;
import org.selectiverenderer.x3d.source.TextEdit;

/** What is found in a text, and what comes in its place. */
class TextSearchTest {
  private static TextSearch words(String words) throws BadSearch {
    return TextSearch.of(new Wanted(words, false, false, false));
  }

  private static TextSearch expression(String words) throws BadSearch {
    return TextSearch.of(new Wanted(words, true, true, false));
  }

  private static String applied(Edit edit, String text) {
    return TextEdit.applied(edit.changes(), text).toString();
  }

  @Test
  void wordsAreFoundWhateverTheirCaseUnlessItIsAsked() throws BadSearch {
    String text = "Cup cup CUP (.*)";
    assertThat(words("cup").all(text, 0, text.length())).hasSize(3);
    TextSearch exact = TextSearch.of(new Wanted("cup", false, true, false));
    assertThat(exact.all(text, 0, text.length())).containsExactly(new Hit(4, 7));
    assertThat(words("(.*)").all(text, 0, text.length())).containsExactly(new Hit(12, 16));
  }

  @Test
  void wholeWordsHaveNoLetterBesideThem() throws BadSearch {
    String text = "cup cups tea_cup κούπα κούπαs";
    TextSearch whole = TextSearch.of(new Wanted("cup", false, false, true));
    assertThat(whole.all(text, 0, text.length())).containsExactly(new Hit(0, 3));
    TextSearch greek = TextSearch.of(new Wanted("ΚΟΎΠΑ", false, false, true));
    assertThat(greek.all(text, 0, text.length())).hasSize(1);
  }

  @Test
  void onlyARangeIsSearchedAndEmptyHitsAreNone() throws BadSearch {
    assertThat(words("a").all("aaaa", 1, 3)).hasSize(2);
    assertThat(expression("x*").all("axxb", 0, 4)).containsExactly(new Hit(1, 3));
  }

  @Test
  void allHitsAreReplacedInOneEditWithGroups() throws BadSearch {
    String text = "size='1 2' size='3 4'";
    Edit edit =
        expression("size='(\\d) (\\d)'").replaceAll(text, 0, text.length(), "size='$2 $1\\$'", "r");
    assertThat(applied(edit, text)).isEqualTo("size='2 1$' size='4 3$'");
    Edit plain = words("size").replaceAll(text, 0, text.length(), "$1", "r");
    assertThat(applied(plain, text)).isEqualTo("$1='1 2' $1='3 4'");
  }

  @Test
  void oneHitIsReplacedWithWhatStandsAroundItInView() throws BadSearch {
    String text = "ab cb";
    Hit hit = expression("(?<=c)b").all(text, 0, text.length()).get(0);
    Edit edit = expression("(?<=c)b").replace(text, hit, "X", "r");
    assertThat(applied(edit, text)).isEqualTo("ab cX");
    assertThatThrownBy(() -> words("zz").replace(text, hit, "X", "r"))
        .isInstanceOf(BadSearch.class)
        .hasMessageContaining("search again");
  }

  @Test
  void whatIsNoExpressionIsTold() {
    assertThatThrownBy(() -> expression("(a"))
        .isInstanceOf(BadSearch.class)
        .hasMessageStartingWith("This is not a valid regular expression");
    assertThatThrownBy(() -> expression("a").replaceAll("a", 0, 1, "$7", "r"))
        .hasMessageContaining("no group 7");
  }

  @Test
  void anExpressionThatNeverEndsIsGivenUp() {
    String text = "a".repeat(60) + "b";
    assertThatThrownBy(() -> expression("(a+)+\\1c").all(text, 0, text.length()))
        .isInstanceOf(BadSearch.class)
        .hasMessageContaining("too long");
    String longer = "ab".repeat(200_000);
    assertThatThrownBy(() -> expression("(a|b)*c").all(longer, 0, longer.length()))
        .isInstanceOf(BadSearch.class);
  }

  @Test
  void hitsAreInOrder() throws BadSearch {
    List<Hit> hits = words("aa").all("aaaaa", 0, 5);
    assertThat(hits).containsExactly(new Hit(0, 2), new Hit(2, 4));
  }
}
