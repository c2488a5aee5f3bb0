package org.selectiverenderer.app.studies;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** A study of questions only, whose sessions show no scene. */
public final class SmallStudy {
  private SmallStudy() {}

  /** Writes it into a folder and returns its file. */
  public static Path write(Path folder) throws IOException {
    return write(folder, false);
  }

  /**
   * Writes it into a folder and returns its file.
   *
   * @param blind whether its groups are hidden
   */
  public static Path write(Path folder, boolean blind) throws IOException {
    Files.createDirectories(folder);
    Files.writeString(
        folder.resolve("items.csv"),
        """
        area,object,consistency,present,en,el
        hall,coat,consistent,yes,Coat,Παλτό
        hall,lamp,consistent,no,Lamp,Λάμπα
        """);
    return Files.writeString(
        folder.resolve("study.json"),
        """
        {"name": "Small study", "conditions": ["high", "selective"], "participants": 4, "seed": 3,
         "blind": %s,
         "questionnaires": [{"kind": "recognition", "items": "items.csv"}]}
        """
            .formatted(blind));
  }
}
