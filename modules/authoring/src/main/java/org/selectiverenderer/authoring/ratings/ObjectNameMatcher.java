package org.selectiverenderer.authoring.ratings;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.base.problem.SpellingSuggester;

/**
 * Matches the objects of a questionnaire with the Switches of a scene by their names; matches can
 * be corrected. A match by a similar name is only proposed until {@link #choose} confirms it.
 */
public final class ObjectNameMatcher {
  /** How an object was matched with its Switch. */
  public enum How {
    /** The names are equal except for prefixes, case and punctuation. */
    SAME_NAME,
    /** The author chose the Switch. */
    CHOSEN,
    /** The names are similar; the match is only proposed. */
    PROPOSED,
    /** There is no Switch. */
    NONE
  }

  /**
   * @param switchName empty for {@link How#NONE}
   */
  public record Match(String object, Optional<String> switchName, How how) {
    /** Returns whether ratings of the object are used. */
    public boolean counts() {
      return how == How.SAME_NAME || how == How.CHOSEN;
    }
  }

  private final Map<String, Match> matches = new LinkedHashMap<>();

  /**
   * @param objects names of the objects in the questionnaire
   */
  public ObjectNameMatcher(Set<String> objects, List<EnrichedSwitch> switches) {
    Map<String, String> byName = new TreeMap<>();
    for (EnrichedSwitch node : switches) {
      for (String name : names(node)) {
        byName.putIfAbsent(name, node.name());
      }
    }
    for (String object : objects) {
      matches.put(object, match(object, byName));
    }
  }

  /** Returns the normalised names of a Switch, from its DEF name and its first file. */
  private static List<String> names(EnrichedSwitch node) {
    List<String> names = new ArrayList<>(List.of(plain(node.name()), plain(node.object())));
    if (!node.choices().isEmpty()) {
      String url = node.choices().get(0).url();
      String file = url.substring(url.lastIndexOf('/') + 1);
      int end = file.indexOf('.');
      names.add(plain((end < 0 ? file : file.substring(0, end)).replaceFirst("_v\\d+$", "")));
    }
    names.removeIf(String::isEmpty);
    return names;
  }

  private static String plain(String name) {
    StringBuilder letters = new StringBuilder();
    name.toLowerCase(Locale.ROOT)
        .codePoints()
        .filter(Character::isLetterOrDigit)
        .forEach(letters::appendCodePoint);
    return letters.toString();
  }

  private static Match match(String object, Map<String, String> byName) {
    String plain = plain(object);
    String same = byName.get(plain);
    if (same != null) {
      return new Match(object, Optional.of(same), How.SAME_NAME);
    }
    Optional<String> near = SpellingSuggester.nearest(plain, byName.keySet());
    if (near.isEmpty() && plain.length() > 2) {
      near =
          byName.keySet().stream()
              .filter(name -> name.contains(plain) || name.length() > 2 && plain.contains(name))
              .findFirst();
    }
    return near.map(name -> new Match(object, Optional.of(byName.get(name)), How.PROPOSED))
        .orElse(new Match(object, Optional.empty(), How.NONE));
  }

  /** Returns the matches of all objects in the order of the table. */
  public List<Match> matches() {
    return List.copyOf(matches.values());
  }

  /** Sets the Switch of an object. */
  public void choose(String object, String switchName) {
    matches.put(object, new Match(object, Optional.of(switchName), How.CHOSEN));
  }

  /** Sets that an object has no Switch. */
  public void leaveOut(String object) {
    matches.put(object, new Match(object, Optional.empty(), How.NONE));
  }
}
