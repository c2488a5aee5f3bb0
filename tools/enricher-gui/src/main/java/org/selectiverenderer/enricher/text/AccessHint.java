package org.selectiverenderer.enricher.text;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Says in the words of the window what messages for the command line say of {@code --allow}: that
 * the dialog of the Scene menu allows a folder or a host.
 */
public final class AccessHint {
  private static final List<Pattern> FOLDER =
      List.of(
          Pattern.compile("; --allow (?<place>\"[^\"]*\"|\\S+) would allow it"),
          Pattern.compile(" \\(see --allow\\)"));
  private static final Pattern HOST =
      Pattern.compile("; --allow-net (?<place>\\S+)(?: as well)? would allow it");

  private AccessHint() {}

  /** Returns a message in which the dialog takes the place of the options. */
  public static String inWindow(String message) {
    if (!message.contains("--allow")) {
      return message;
    }
    String said = replaced(message, HOST, "access.hint.host");
    said = replaced(said, FOLDER.get(0), "access.hint.folder");
    return FOLDER.get(1).matcher(said).replaceAll(Matcher.quoteReplacement(plain()));
  }

  /** Returns a sentence that names the dialog. */
  public static String ofDialog() {
    return Texts.of("access.hint.dialog", command());
  }

  private static String plain() {
    return Texts.of("access.hint", command());
  }

  private static String replaced(String message, Pattern option, String text) {
    return option
        .matcher(message)
        .replaceAll(found -> Matcher.quoteReplacement(Texts.of(text, found.group(1), command())));
  }

  /** Returns the menu and the command that open the dialog. */
  private static String command() {
    return Mnemonics.without(Texts.of("menu.file"))
        + " > "
        + Mnemonics.without(Texts.of("access.command")).replace("...", "");
  }
}
