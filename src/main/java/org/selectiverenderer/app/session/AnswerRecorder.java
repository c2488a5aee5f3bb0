package org.selectiverenderer.app.session;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.OptionalLong;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicReference;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.study.questionnaire.Answer;
import org.selectiverenderer.study.questionnaire.Question;
import org.selectiverenderer.study.questionnaire.QuestionnairePage;
import org.selectiverenderer.study.questionnaire.QuestionnaireProgress;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.study.session.SessionStep;

/**
 * Records the answers of a questionnaire in the session's journal, and remembers a failure to
 * write.
 */
final class AnswerRecorder implements QuestionnaireProgress.Listener {
  private final Session session;
  private final SessionStep step;
  private final Map<String, Answer> answers = new ConcurrentHashMap<>();
  private final AtomicReference<@Nullable IOException> failure = new AtomicReference<>();

  AnswerRecorder(Session session, SessionStep step) {
    this.session = session;
    this.step = step;
    answers.putAll(session.answers(step));
  }

  @Override
  public void shown(QuestionnairePage page, List<Question> asked) {
    session.shown(step, page, asked);
  }

  @Override
  public void answered(Question question, Answer answer, long milliseconds, int place) {
    answers.put(question.id(), answer);
    try {
      session.answer(step, question, answer, OptionalLong.of(milliseconds), place);
    } catch (IOException e) {
      failure.set(e);
    }
  }

  /** Returns all answers, keyed by the ids of the questions. */
  Map<String, Answer> all() {
    return Map.copyOf(answers);
  }

  /** Returns whether an answer could not be written; then no more questions need be asked. */
  boolean failed() {
    return failure.get() != null;
  }

  /**
   * Throws the failure to write an answer, if there was one.
   *
   * @throws IOException if an answer could not be written
   */
  void check() throws IOException {
    IOException failed = failure.get();
    if (failed != null) {
      throw failed;
    }
  }
}
