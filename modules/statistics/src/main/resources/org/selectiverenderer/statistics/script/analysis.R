# Repeats the analyses of a recognition study and adds the mixed probit of single answers.
# Run it in this folder:  Rscript analysis.R [AREA ...]
# Uses base R; with the package afex its analyses of variance, with lme4 the mixed probit
# (install.packages(c("afex", "lme4")), or on Debian r-cran-afex and r-cran-lme4).

responses <- @RESPONSES@
correction <- @CORRECTION@ # of rates of 0 and 1: loglinear, half or none
guesses <- @GUESSES@ # answers below a level of confidence: discard, or no

here <- sub("^--file=", "", grep("^--file=", commandArgs(FALSE), value = TRUE))
if (length(here) == 1 && !file.exists(responses)) responses <- file.path(dirname(here), responses)
if (!file.exists(responses)) stop("there is no file ", responses, "; run this script in its folder", call. = FALSE)
answers <- read.csv(responses, colClasses = "character", fileEncoding = "UTF-8", check.names = FALSE)
needed <- c("participant", "condition", "area", "object", "consistency", "present", "response", "confidence")
if (!all(needed %in% names(answers))) {
  stop(responses, " lacks ", paste(setdiff(needed, names(answers)), collapse = ", "), call. = FALSE)
}
answers <- answers[answers$present %in% c("yes", "no") & answers$response %in% c("yes", "no"), ]
answers$confidence <- suppressWarnings(as.integer(answers$confidence))
answers$old <- answers$present == "yes"
answers$yes <- answers$response == "yes"
wanted <- commandArgs(TRUE)
areas <- unique(answers$area)
if (length(wanted)) areas <- intersect(areas, wanted)
if (!length(areas)) stop("no such area; there are ", paste(unique(answers$area), collapse = ", "), call. = FALSE)

have_afex <- requireNamespace("afex", quietly = TRUE)
have_lme4 <- requireNamespace("lme4", quietly = TRUE)
options(contrasts = c("contr.sum", "contr.poly"))
decimals <- function(x, n = 3) formatC(x, digits = n, format = "f")

rate <- function(count, total) {
  if (total == 0) return(NaN)
  switch(correction,
    loglinear = (count + 0.5) / (total + 1),
    half = pmin(1 - 0.5 / total, pmax(0.5 / total, count / total)),
    none = count / total)
}

# d', log beta and c of each participant and type of object, of the answers at a level.
scores <- function(d, least) {
  at_level <- if (least == 0) rep(TRUE, nrow(d)) else !is.na(d$confidence) & d$confidence >= least
  if (guesses == "no" && least > 0) {
    d <- d[!is.na(d$confidence), ]
    at_level <- d$confidence >= least
    d$yes <- d$yes & at_level
  } else if (guesses == "no") {
    # Every answer is at this level, also one without a confidence.
  } else {
    d <- d[at_level, ]
  }
  if (!nrow(d)) return(NULL)
  cell <- interaction(d$participant, d$consistency, drop = TRUE)
  rows <- lapply(split(d, cell), function(x) {
    h <- rate(sum(x$yes & x$old), sum(x$old))
    f <- rate(sum(x$yes & !x$old), sum(!x$old))
    data.frame(participant = x$participant[1], condition = x$condition[1], type = x$consistency[1],
      d_prime = qnorm(h) - qnorm(f), log_beta = (qnorm(f)^2 - qnorm(h)^2) / 2, c = -(qnorm(h) + qnorm(f)) / 2)
  })
  s <- do.call(rbind, rows)
  rownames(s) <- NULL
  complete <- tapply(is.finite(s$d_prime), s$participant, sum) == length(unique(d$consistency))
  s <- s[s$participant %in% names(which(complete)), ]
  s$condition <- factor(s$condition); s$type <- factor(s$type); s$participant <- factor(s$participant)
  s
}

# Effects with F, degrees of freedom and p, without a correction of sphericity.
effects_of <- function(s, measure) {
  s$y <- s[[measure]]
  groups <- nlevels(s$condition) > 1; types <- nlevels(s$type) > 1
  if (!groups && !types) return(NULL)
  if (have_afex) {
    a <- suppressMessages(suppressWarnings(afex::aov_ez("participant", "y", s,
      between = if (groups) "condition", within = if (types) "type", type = 3,
      anova_table = list(correction = "none", es = "pes"))))
    t <- as.data.frame(a$anova_table)
    return(data.frame(effect = rownames(t), df1 = t[["num Df"]], df2 = t[["den Df"]], F = t[["F"]], p = t[["Pr(>F)"]]))
  }
  # Base R: exact for two types or one, or with equal groups.
  out <- NULL
  add <- function(effect, table, row) {
    out <<- rbind(out, data.frame(effect, df1 = table[row, "Df"], df2 = table["Residuals", "Df"],
      F = table[row, "F value"], p = table[row, "Pr(>F)"]))
  }
  wide <- tapply(s$y, list(s$participant, s$type), mean)
  who <- s$condition[match(rownames(wide), s$participant)]
  if (groups) {
    m <- lm(rowMeans(wide) ~ who)
    add("condition", with_residual(drop1(m, . ~ ., test = "F"), m), "who")
  }
  if (types && ncol(wide) == 2) {
    difference <- wide[, 2] - wide[, 1]
    m <- if (groups) lm(difference ~ who) else lm(difference ~ 1)
    k <- summary(m)$coefficients[1, ]
    out <- rbind(out, data.frame(effect = "type", df1 = 1, df2 = m$df.residual, F = k[["t value"]]^2, p = k[["Pr(>|t|)"]]))
    if (groups) add("condition:type", with_residual(drop1(m, . ~ ., test = "F"), m), "who")
  } else if (types) {
    cat("  (more than two types of objects: install afex for the effects within participants)\n")
  }
  out
}
with_residual <- function(table, model) {
  t <- as.data.frame(table)
  t["Residuals", "Df"] <- model$df.residual
  t
}

# Probit of "yes": the coefficient of old is d', those of old with condition and type are effects on
# d'; without old they are effects on the criterion, with the opposite sign.
# DeCarlo 1998, Psychological Methods 3; Wright, Horry and Skagerberg 2009, Behavior Research Methods 41.
mixed_probit <- function(d) {
  if (!have_lme4) {
    cat("Mixed probit: not computed, the package lme4 is not installed.\n")
    return(NULL)
  }
  d$old_c <- ifelse(d$old, 0.5, -0.5)
  d$condition <- factor(d$condition); d$type <- factor(d$consistency); d$item <- factor(d$object)
  fixed <- "old_c"
  if (nlevels(d$condition) > 1) fixed <- paste(fixed, "* condition")
  if (nlevels(d$type) > 1) fixed <- paste(fixed, "* type")
  random <- c("(1 + old_c | participant) + (1 | item)", "(1 | participant) + (1 | item)")
  for (r in random) {
    model <- as.formula(paste("yes ~", fixed, "+", r))
    unit <- suppressMessages(lme4::glFormula(model, data = d, family = binomial("probit")))$reTrms$theta
    m <- NULL; warned <- character()
    # From one start the search may end where a variance is 0 although the likelihood is higher
    # elsewhere: then it begins anew from others, and the best counts.
    for (size in c(0.3, 1, 0.1)) {
      own <- character()
      fit <- tryCatch(
        withCallingHandlers(
          lme4::glmer(model, data = d, family = binomial("probit"), start = list(theta = size * unit),
            control = lme4::glmerControl(optimizer = "bobyqa", optCtrl = list(maxfun = 2e5))),
          warning = function(w) { own <<- c(own, conditionMessage(w)); invokeRestart("muffleWarning") },
          message = function(w) invokeRestart("muffleMessage")),
        error = function(e) { own <<- c(own, conditionMessage(e)); NULL })
      warned <- c(warned, own)
      usable <- !is.null(fit) && !any(grepl("failed to converge|unidentifiable", own))
      if (usable && (is.null(m) || logLik(fit) > logLik(m))) m <- fit
      if (!is.null(m) && !lme4::isSingular(m)) break
    }
    if (!is.null(m)) break
    cat("  ", r, " did not converge: ", paste(unique(warned), collapse = "; "), "\n", sep = "")
  }
  if (is.null(m)) {
    cat("Mixed probit: no model converged.\n")
    return(NULL)
  }
  cat("Mixed probit: yes ~ ", fixed, " + ", r, "\n", sep = "")
  cat("  log likelihood =", decimals(as.numeric(logLik(m))), "\n")
  if (lme4::isSingular(m)) cat("  a variance is estimated as 0 (singular fit)\n")
  print(lme4::VarCorr(m), comp = "Std.Dev.")
  # Wald chi-squared of each term (type III, contrasts that sum to 0).
  beta <- lme4::fixef(m); v <- as.matrix(vcov(m))
  term <- attr(model.matrix(m), "assign")
  labels <- attr(terms(m), "term.labels")
  out <- do.call(rbind, lapply(seq_along(labels), function(i) {
    at <- which(term == i)
    w <- drop(t(beta[at]) %*% solve(v[at, at, drop = FALSE], beta[at]))
    data.frame(term = labels[i], df = length(at), chisq = w, p = pchisq(w, length(at), lower.tail = FALSE))
  }))
  cat("  d' =", decimals(beta[["old_c"]]), " SE =", decimals(sqrt(v["old_c", "old_c"])), "\n")
  out
}

show <- function(table, digits = 3) {
  for (name in names(table)[vapply(table, is.double, TRUE)]) {
    x <- table[[name]]
    table[[name]] <- if (grepl("^df", name)) format(x) else formatC(x, digits = digits, format = "f")
    if (grepl("^p\\b", name)) table[[name]][!is.na(x) & x < 0.001] <- "< .001"
  }
  print(table, row.names = FALSE)
}

for (area in areas) {
  d <- answers[answers$area == area, ]
  cat("\n== ", area, " ==\n", sep = "")
  levels <- c("all answers" = 0, "confidence 3-5" = 3, "confidence 5" = 5)
  for (name in names(levels)) {
    s <- scores(d, levels[[name]])
    if (is.null(s) || nlevels(droplevels(s$participant)) < 3) { cat(name, ": too few scores\n", sep = ""); next }
    s <- droplevels(s)
    cat("\n", name, ", n = ", nlevels(s$participant), "\n", sep = "")
    means <- do.call(rbind, lapply(split(s, list(s$type, s$condition), drop = TRUE), function(x) data.frame(
      type = x$type[1], condition = x$condition[1], n = nrow(x), d_prime = mean(x$d_prime),
      sd_d_prime = sd(x$d_prime), log_beta = mean(x$log_beta), sd_log_beta = sd(x$log_beta), c = mean(x$c),
      sd_c = sd(x$c))))
    show(means)
    for (measure in c("d_prime", "log_beta", "c")) {
      e <- tryCatch(effects_of(s, measure), error = function(e) { cat("  ", measure, ": ", conditionMessage(e), "\n", sep = ""); NULL })
      if (!is.null(e)) { cat(measure, ":\n", sep = ""); show(e) }
      if (measure == "d_prime" && levels[[name]] == 0) first <- e
    }
  }
  cat("\n")
  probit <- mixed_probit(d)
  if (!is.null(probit)) {
    show(probit)
    on_d <- probit[grepl("^old_c:", probit$term), ]
    on_d$effect <- sub("^old_c:", "", on_d$term)
    both <- merge(if (is.null(first)) data.frame(effect = character(), p = numeric()) else first[, c("effect", "p")],
      on_d[, c("effect", "p")], by = "effect", all = TRUE, suffixes = c(" (d' of participants)", " (mixed probit)"))
    if (nrow(both)) {
      cat("\nEffects on sensitivity, all answers:\n")
      show(both)
      cat("Where the two differ, prefer the mixed probit: it corrects no rates, and weighs each\n",
        "participant by how many answers there are.\n", sep = "")
    }
  }
}
cat("\n", R.version.string, if (have_afex) paste0(", afex ", packageVersion("afex")),
  if (have_lme4) paste0(", lme4 ", packageVersion("lme4")), "\n", sep = "")
