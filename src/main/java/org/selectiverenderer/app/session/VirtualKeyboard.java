package org.selectiverenderer.app.session;

import java.text.Normalizer;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.selectiverenderer.study.questionnaire.ButtonQuestionnaireController;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;

/**
 * The virtual keyboard inside a headset: letters of the study's language and of English, or digits
 * for a number. An accent is a dead key before its letter, as on Greek keyboards.
 */
final class VirtualKeyboard {
  private static final List<String> ENGLISH =
      List.of("1234567890", "qwertyuiop", "asdfghjkl'", "zxcvbnm,.?");
  private static final List<String> GREEK =
      List.of("1234567890", "ςερτυθιοπ¨", "ασδφγηξκλ΄", "ζχψωβνμ,.;");
  private static final List<String> NUMBER = List.of("123", "456", "789", "-0.");

  private final ParticipantMessages wording;
  private boolean greek;
  private boolean capitals;
  private String accent = "";

  /**
   * A key.
   *
   * @param width width as a multiple of a letter's key
   * @param held whether the key is active for the next letter
   */
  record Key(String label, double width, boolean held, Runnable press) {}

  VirtualKeyboard(ParticipantMessages wording) {
    this.wording = wording;
    greek = wording.language().equals("el");
  }

  /** Returns the rows of keys for the current question. */
  List<List<Key>> rows(ButtonQuestionnaireController asked) {
    boolean number = asked.line().filter(line -> line.range().isPresent()).isPresent();
    List<List<Key>> rows = new ArrayList<>();
    for (String row : number ? NUMBER : greek ? GREEK : ENGLISH) {
      rows.add(row.chars().mapToObj(letter -> key((char) letter, asked)).toList());
    }
    List<Key> last = new ArrayList<>();
    if (!number) {
      last.add(new Key(greek ? "ΑΒΓ" : "ABC", 1.5, capitals, () -> capitals = !capitals));
      last.add(new Key(greek ? "EN" : "ΕΛ", 1.5, false, () -> greek = !greek));
      last.add(new Key(wording.of("headset.space"), 4, false, () -> write(" ", asked)));
    }
    last.add(new Key(wording.of("headset.erase"), 3, false, asked::erase));
    rows.add(last);
    return rows;
  }

  private Key key(char letter, ButtonQuestionnaireController asked) {
    if (letter == '΄' || letter == '¨') {
      String mark = letter == '΄' ? "\u0301" : "\u0308";
      return new Key(
          Character.toString(letter),
          1,
          accent.equals(mark),
          () -> accent = accent.equals(mark) ? "" : mark);
    }
    String plain = Character.toString(letter);
    String label = capitals && letter != 'ς' ? plain.toUpperCase(Locale.ROOT) : plain;
    return new Key(label, 1, false, () -> write(label, asked));
  }

  private void write(String letter, ButtonQuestionnaireController asked) {
    String with = Normalizer.normalize(letter + accent, Normalizer.Form.NFC);
    asked.write(with.length() == 1 ? with : letter);
    accent = "";
    capitals = false;
  }
}
