package org.selectiverenderer.study.site;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.study.session.JournalContent;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.ParticipantsFile;
import org.selectiverenderer.study.session.SessionFolder;

/**
 * The sites of a study, in the order in which they were named.
 *
 * @param sites at least one
 */
public record StudySites(List<StudySite> sites) {
  public StudySites {
    sites = List.copyOf(sites);
  }

  /**
   * Reads the folders of the sites. What each session records of the study must be what the study
   * is now.
   *
   * @param from the folders by the names of the sites, which consist of letters and digits
   * @param anyVersion whether sessions of other versions of the study count, too; else they are
   *     passed over and reported
   * @return empty if participants of several sites would have the same id, or if the study's own
   *     folder has sessions and no name; the fault is then in {@code problems}
   * @throws IOException if a folder is none, or cannot be read
   */
  public static Optional<StudySites> read(
      LoadedStudy material, Map<String, Path> from, boolean anyVersion, ProblemCollector problems)
      throws IOException {
    if (!named(material, from, problems)) {
      return Optional.empty();
    }
    StudyVersion version = StudyVersion.of(material);
    Map<String, String> beginnings = new HashMap<>();
    List<StudySite> sites = new ArrayList<>();
    for (Map.Entry<String, Path> one : from.entrySet()) {
      LoadedStudy there =
          material.at(one.getValue().resolve(material.study().file().getFileName()));
      List<SessionFolder> all = SessionFolder.all(there.study());
      if (all.isEmpty()) {
        problems.warning(
            SourceLocation.of(one.getValue().toString()),
            "the site %s has no sessions here; name the folder with its sub-... folders"
                .formatted(one.getKey()));
      }
      List<SessionFolder> own = new ArrayList<>();
      for (SessionFolder session : all) {
        if (isFirst(session, one.getKey(), beginnings, problems)) {
          own.add(session);
        }
      }
      sites.add(
          new StudySite(
              one.getKey(), there, Set.copyOf(taken(own, version, anyVersion, problems))));
    }
    StudySites read = new StudySites(sites);
    if (!read.distinct(problems)) {
      return Optional.empty();
    }
    read.tellIds(problems);
    read.tellPlaces(problems);
    return Optional.of(read);
  }

  /** Returns whether all folders are named; a folder twice would count its sessions twice. */
  private static boolean named(
      LoadedStudy material, Map<String, Path> from, ProblemCollector problems) throws IOException {
    Map<Path, String> real = new HashMap<>();
    boolean named = true;
    for (Map.Entry<String, Path> one : from.entrySet()) {
      if (!Files.isDirectory(one.getValue())) {
        throw new IOException(
            "%s: is no folder; --from names a site and its folder, as in --from %s=FOLDER"
                .formatted(one.getValue(), one.getKey()));
      }
      String other = real.put(one.getValue().toRealPath(), one.getKey());
      if (other != null) {
        problems.error(
            SourceLocation.of(one.getValue().toString()),
            "the sites %s and %s have the same folder; name each folder once"
                .formatted(other, one.getKey()));
        named = false;
      }
    }
    Path own = material.study().folder();
    if (!real.containsKey(own.toRealPath()) && !SessionFolder.all(material.study()).isEmpty()) {
      problems.error(
          SourceLocation.of(own.toString()),
          "the study's own folder has sessions, too; give it the name of a site as well, as in"
              + " --from here="
              + own);
      named = false;
    }
    return named;
  }

  /** Returns whether a session is no copy of one that another site, or another id, has. */
  private static boolean isFirst(
      SessionFolder session, String site, Map<String, String> beginnings, ProblemCollector problems)
      throws IOException {
    JournalContent journal = JournalContent.read(session.journal());
    if (journal.events().isEmpty()) {
      return true; // Others report it.
    }
    String where = "sub-%s of %s".formatted(session.participant(), site);
    String other = beginnings.putIfAbsent(journal.events().get(0).toString(), where);
    if (other != null) {
      problems.error(
          SourceLocation.of(session.journal().toString()),
          "this is a copy of the session %d of %s, which is taken; the copy is left out"
              .formatted(session.number(), other));
    }
    return other == null;
  }

  /** Returns the sessions of this version of the study; reports the others. */
  private static Set<SessionFolder> taken(
      List<SessionFolder> all, StudyVersion version, boolean any, ProblemCollector problems)
      throws IOException {
    Set<SessionFolder> taken = new LinkedHashSet<>();
    Map<List<String>, List<SessionFolder>> others = new LinkedHashMap<>();
    for (SessionFolder session : all) {
      List<String> differences = version.differences(session);
      if (differences.isEmpty() || any) {
        taken.add(session);
      }
      if (!differences.isEmpty()) {
        others.computeIfAbsent(differences, key -> new ArrayList<>()).add(session);
      }
    }
    others.forEach(
        (differences, sessions) -> {
          SourceLocation place = SourceLocation.of(sessions.get(0).journal().toString());
          String who =
              (sessions.size() == 1 ? "the session of " : "the sessions of ")
                  + String.join(", ", sessions.stream().map(StudySites::name).toList());
          String verb = sessions.size() == 1 ? "has" : "have";
          String what = String.join("; ", differences);
          if (any) {
            problems.warning(
                place, "%s %s another version of the study: %s".formatted(who, verb, what));
          } else {
            problems.error(
                place,
                "%s %s another version of the study (%s) and %s left out; --any-version takes %s"
                    .formatted(
                        who,
                        verb,
                        what,
                        sessions.size() == 1 ? "is" : "are",
                        sessions.size() == 1 ? "it" : "them"));
          }
        });
    return taken;
  }

  private static String name(SessionFolder session) {
    return "sub-%s/%s".formatted(session.participant(), session.path().getFileName());
  }

  /** Returns whether all participants get ids of their own, as names of folders, too. */
  private boolean distinct(ProblemCollector problems) {
    Map<String, String> ids = new HashMap<>();
    boolean distinct = true;
    for (StudySite site : sites) {
      for (String participant : site.participants()) {
        String id = site.id(participant);
        String where = "%s of %s".formatted(participant, site.name());
        String other = ids.putIfAbsent(id.toLowerCase(Locale.ROOT), where);
        if (other != null) {
          problems.error(
              SourceLocation.of(site.material().study().folder().toString()),
              ("the participants %s and %s would both be %s; give one of the sites another name,"
                      + " which ends with a letter")
                  .formatted(other, where, id));
          distinct = false;
        }
      }
    }
    return distinct;
  }

  /** Says which ids several sites gave to different people. */
  private void tellIds(ProblemCollector problems) {
    Map<String, List<StudySite>> ids = new TreeMap<>();
    for (StudySite site : sites) {
      site.participants()
          .forEach(
              id ->
                  ids.computeIfAbsent(id.toLowerCase(Locale.ROOT), key -> new ArrayList<>())
                      .add(site));
    }
    Map<List<StudySite>, List<String>> doubled = new LinkedHashMap<>();
    ids.forEach(
        (id, at) -> {
          if (at.size() > 1) {
            doubled.computeIfAbsent(at, key -> new ArrayList<>()).add(id);
          }
        });
    doubled.forEach(
        (at, same) ->
            problems.info(
                SourceLocation.of(at.get(1).material().study().folder().toString()),
                ("%s %s at %s; they count as different people, and are %s in the tables. If one"
                        + " person took part at two sites, leave one of the sessions out")
                    .formatted(
                        same.size() == 1
                            ? "there is a participant " + same.get(0)
                            : "there are participants " + String.join(", ", same),
                        at.size() == 2 ? "both" : "each",
                        String.join(" and ", at.stream().map(StudySite::name).toList()),
                        String.join(
                            " and ", at.stream().map(site -> site.id(same.get(0))).toList()))));
  }

  /** Says which places of the schedule several sites gave away. */
  private void tellPlaces(ProblemCollector problems) throws IOException {
    Map<Integer, Set<String>> at = new TreeMap<>();
    for (StudySite site : sites) {
      List<String> here = site.participants();
      for (ParticipantsFile.Assigned one : new ParticipantsFile(site.material().study()).all()) {
        if (here.contains(one.participant())) {
          at.computeIfAbsent(one.place(), place -> new TreeSet<>()).add(site.name());
        }
      }
    }
    List<String> places = new ArrayList<>();
    Set<String> names = new TreeSet<>();
    at.forEach(
        (place, all) -> {
          if (all.size() > 1) {
            places.add(String.valueOf(place));
            names.addAll(all);
          }
        });
    if (!places.isEmpty()) {
      problems.info(
          SourceLocation.of(sites.get(0).material().study().folder().toString()),
          ("%s of the schedule %s given away more than once, at %s: groups and orders are balanced"
                  + " at each site by itself, not in all. The data counts; analyse with the factor"
                  + " site. For one schedule, let all sites share one participants.tsv, by a folder"
                  + " that all can write")
              .formatted(
                  places.size() == 1
                      ? "the place " + places.get(0)
                      : "the places " + String.join(", ", places),
                  places.size() == 1 ? "was" : "were",
                  String.join(", ", names)));
    }
  }
}
