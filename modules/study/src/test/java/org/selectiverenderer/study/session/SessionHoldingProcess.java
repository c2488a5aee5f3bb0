package org.selectiverenderer.study.session;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import org.selectiverenderer.base.problem.ProblemCollector;

/**
 * A process that runs a session: says "held", or why it cannot, and goes on until its input ends.
 */
final class SessionHoldingProcess {
  private SessionHoldingProcess() {}

  /**
   * @param args the study file, the participant, and begin, resume or fill, which adds events until
   *     that fails
   */
  public static void main(String[] args) throws IOException {
    LoadedStudy material = LoadedStudy.read(Path.of(args[0]), new ProblemCollector()).orElseThrow();
    try (Session session =
        args[2].equals("resume")
            ? Session.resume(
                material, args[1], 1, TwoRoomStudyFixture.OPTIONS, new ProblemCollector())
            : Session.begin(
                material, args[1], 1, TwoRoomStudyFixture.OPTIONS, new ProblemCollector())) {
      while (args[2].equals("fill")) {
        session.journal().keep("note", Map.of("text", "x".repeat(100)));
      }
      System.out.println("held");
      System.in.read();
    } catch (IOException e) {
      System.out.println(e.getMessage());
    }
  }
}
