package org.selectiverenderer.study.site;

import java.util.List;
import java.util.Set;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.SessionFolder;

/**
 * One of the sites at which a study runs.
 *
 * @param name letters and digits, with which the ids of its participants begin
 * @param material the study with the site's folder
 * @param taken the sessions of the site that count
 */
record StudySite(String name, LoadedStudy material, Set<SessionFolder> taken) {
  public StudySite {
    taken = Set.copyOf(taken);
  }

  /** Returns the id in the tables of a participant, whose id at the site is given. */
  String id(String participant) {
    return name + participant;
  }

  /** Returns the site's participants with sessions that count, each once, in order. */
  List<String> participants() {
    return taken.stream().map(SessionFolder::participant).distinct().sorted().toList();
  }
}
