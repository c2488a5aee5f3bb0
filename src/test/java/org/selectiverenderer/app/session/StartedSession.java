package org.selectiverenderer.app.session;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.study.session.SessionOptions;
import org.selectiverenderer.study.session.SessionStep;

/** A session of a study's first participant, who has filled in the form. */
final class StartedSession {
  private StartedSession() {}

  static Session of(Path study) throws IOException {
    LoadedStudy material = LoadedStudy.read(study, new ProblemCollector()).orElseThrow();
    Session session =
        Session.begin(
            material,
            "001",
            1,
            new SessionOptions(Optional.empty(), OptionalDouble.empty(), false, "test"),
            new ProblemCollector());
    SessionStep form = session.remaining().get(0);
    session.began(form, false);
    session.assign("18-22");
    session.finished(form, Map.of());
    return session;
  }
}
