package org.selectiverenderer.study.archive;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** A licence under which data is published, by its identifier of SPDX. */
public enum ArchiveLicence {
  CC0("CC0-1.0", "Creative Commons Zero 1.0", "publicdomain/zero/1.0/"),
  CC_BY("CC-BY-4.0", "Creative Commons Attribution 4.0", "licenses/by/4.0/"),
  CC_BY_SA("CC-BY-SA-4.0", "Creative Commons Attribution-ShareAlike 4.0", "licenses/by-sa/4.0/"),
  CC_BY_NC("CC-BY-NC-4.0", "Creative Commons Attribution-NonCommercial 4.0", "licenses/by-nc/4.0/"),
  CC_BY_NC_SA(
      "CC-BY-NC-SA-4.0",
      "Creative Commons Attribution-NonCommercial-ShareAlike 4.0",
      "licenses/by-nc-sa/4.0/"),
  ODC_BY("ODC-By-1.0", "Open Data Commons Attribution 1.0", "by/1-0/"),
  ODBL("ODbL-1.0", "Open Data Commons Open Database Licence 1.0", "odbl/1-0/"),
  PDDL("PDDL-1.0", "Open Data Commons Public Domain Dedication 1.0", "pddl/1-0/");

  private final String id;
  private final String title;
  private final String path;

  ArchiveLicence(String id, String title, String path) {
    this.id = id;
    this.title = title;
    this.path = path;
  }

  /** Returns the licence with an identifier, in any case of letters. */
  public static Optional<ArchiveLicence> of(String id) {
    return Arrays.stream(values()).filter(one -> one.id.equalsIgnoreCase(id)).findFirst();
  }

  /** Returns the identifiers of all licences. */
  public static List<String> ids() {
    return Arrays.stream(values()).map(ArchiveLicence::id).toList();
  }

  /** Returns the identifier. */
  public String id() {
    return id;
  }

  /** Returns the title and where the text is. */
  String text() {
    String host =
        id.startsWith("CC")
            ? "https://creativecommons.org/"
            : "https://opendatacommons.org/licenses/";
    return "%s (%s)\n%s%s\n".formatted(title, id, host, path);
  }
}
