# Makes factors-data.csv.gz and factors-golden.csv.gz; see README.md beside this file.
suppressMessages({library(afex); library(car); library(emmeans); library(effectsize)})
folder <- commandArgs(trailingOnly = TRUE)[1]
set.seed(20100615)
options(contrasts = c("contr.sum", "contr.poly"))
data_lines <- c("set,subject,a,b,u,v,x,value")
lines <- c("set,key,value")

put <- function(set, key, value) {
  value <- as.numeric(value)
  if (length(value) == 1 && is.finite(value))
    lines[length(lines) + 1] <<- sprintf("%d,%s,%.15g", set, key, value)
}

# Noncentralities by inversion of R's pf and pt.
eta_interval <- function(f, df1, df2) {
  bound <- function(p) {
    if (pf(f, df1, df2) <= p) return(0)
    top <- 10; while (pf(f, df1, df2, top) > p) top <- top * 2
    uniroot(function(l) pf(f, df1, df2, l) - p, c(0, top), tol = 1e-12)$root
  }
  l <- c(bound(0.95), bound(0.05)); l / (l + df1 + df2 + 1)
}
t_interval <- function(t, df) {
  bound <- function(p) uniroot(function(d) pt(t, df, d) - p, c(t - 20, t + 20), tol = 1e-12)$root
  suppressWarnings(c(bound(0.975), bound(0.025)))
}

mauchly_p <- function(w, q, n) { # as in anova-golden.R
  rho <- 1 - (2 * q^2 + q + 2) / (6 * q * n)
  w2 <- (q + 2) * (q - 1) * (q - 2) * (2 * q^3 + 6 * q^2 + 3 * q + 2) / (288 * (n * q * rho)^2)
  z <- -n * rho * log(w); f <- q * (q + 1) / 2 - 1
  first <- pchisq(z, f, lower.tail = FALSE)
  min(1, first + w2 * (pchisq(z, f + 4, lower.tail = FALSE) - first))
}

# Ours: within factors first. car's: between factors first.
ours <- function(name) {
  parts <- strsplit(name, ":")[[1]]
  paste(c(intersect(c("u", "v"), parts), intersect(c("a", "b"), parts), intersect("x", parts)), collapse = " x ")
}

effect <- function(set, name, ss, sse, df1, df2, eps, ges) {
  f <- (ss / df1) / (sse / df2)
  key <- function(what) paste("effect", name, what, sep = "|")
  put(set, key("ss"), ss); put(set, key("error"), sse); put(set, key("df1"), df1); put(set, key("df2"), df2)
  put(set, key("F"), f); put(set, key("ges"), ges)
  put(set, key("p uncorrected"), pf(f, df1, df2, lower.tail = FALSE))
  put(set, key("p"), pf(f, df1 * eps, df2 * eps, lower.tail = FALSE))
  put(set, key("omega"), max(0, F_to_omega2(f, df1, df2, ci = NULL)$Omega2_partial))
  if (name != "intercept") {
    ci <- eta_interval(f, df1 * eps, df2 * eps)
    put(set, key("low"), ci[1]); put(set, key("high"), ci[2])
  }
}

box_m <- function(set, parts) { # Box 1949
  p <- ncol(parts[[1]]); v <- sapply(parts, nrow) - 1; g <- length(parts)
  if (any(v < p)) return(invisible())
  s <- lapply(parts, cov); pooled <- Reduce(`+`, Map(`*`, s, v)) / sum(v)
  m <- sum(v) * log(det(pooled)) - sum(v * sapply(s, function(x) log(det(x))))
  c1 <- (sum(1 / v) - 1 / sum(v)) * (2 * p^2 + 3 * p - 1) / (6 * (p + 1) * (g - 1))
  df <- p * (p + 1) * (g - 1) / 2
  put(set, "box|m", m); put(set, "box|chi", m * (1 - c1)); put(set, "box|p", pchisq(m * (1 - c1), df, lower.tail = FALSE))
}

checks <- function(set, d, between, within, covariate) {
  cell <- if (length(within)) interaction(d[within], lex.order = TRUE) else factor(rep("1", nrow(d)))
  group <- if (length(between)) interaction(d[between], lex.order = TRUE, drop = TRUE) else NULL
  rhs <- paste(c(if (length(between)) paste(between, collapse = "*"), covariate, "1"), collapse = "+")
  for (i in seq_along(levels(cell))) {
    part <- d[cell == levels(cell)[i], ]
    fit <- lm(as.formula(paste("value ~", rhs)), part)
    test <- shapiro.test(residuals(fit))
    put(set, paste0("shapiro|", i, "|W"), test$statistic); put(set, paste0("shapiro|", i, "|p"), test$p.value)
    put(set, paste0("rstudent|", i), max(abs(rstudent(fit))))
    if (length(between)) {
      part$group <- interaction(part[between], lex.order = TRUE)
      part$left <- residuals(fit)
      test <- leveneTest(left ~ group, part, center = median)
      put(set, paste0("levene|", i, "|F"), test[1, "F value"]); put(set, paste0("levene|", i, "|p"), test[1, "Pr(>F)"])
    }
  }
  subjects <- d[!duplicated(d$subject), ]
  if (length(between) && is.null(covariate)) {
    subjects$mean <- tapply(d$value, d$subject, mean)[as.character(subjects$subject)]
    subjects$group <- interaction(subjects[between], lex.order = TRUE)
    test <- oneway.test(mean ~ group, subjects)
    put(set, "welch|F", test$statistic); put(set, "welch|df2", test$parameter[2]); put(set, "welch|p", test$p.value)
    if (length(within)) {
      wide <- sapply(levels(cell), function(l) d$value[cell == l][match(subjects$subject, d$subject[cell == l])])
      box_m(set, lapply(split(seq_len(nrow(subjects)), subjects$group), function(i) wide[i, , drop = FALSE]))
    }
  }
}

kinds <- list(
  list(b = c(2, 3), w = NULL, x = FALSE), list(b = NULL, w = c(2, 3), x = FALSE),
  list(b = c(2, 2), w = 3, x = FALSE), list(b = 3, w = c(3, 2), x = FALSE),
  list(b = 3, w = NULL, x = TRUE), list(b = 2, w = 4, x = TRUE),
  list(b = c(2, 2), w = c(2, 2), x = FALSE), list(b = c(2, 2), w = 3, x = TRUE),
  list(b = 3, w = 4, x = FALSE), list(b = NULL, w = 5, x = FALSE))

for (set in 1:60) {
  kind <- kinds[[(set - 1) %% length(kinds) + 1]]
  between <- c("a", "b")[seq_along(kind$b)]; within <- c("u", "v")[seq_along(kind$w)]
  groups <- expand.grid(rev(lapply(kind$b, seq_len))); groups <- groups[, rev(seq_along(groups)), drop = FALSE]
  g <- max(1, nrow(groups)); k <- prod(kind$w)
  n <- if (set %% 3 == 0) rep(sample(6:12, 1), g) else sample(5:14, g, replace = TRUE)
  if (g == 1) n <- n + k + 5
  cells <- expand.grid(rev(lapply(kind$w, seq_len))); cells <- cells[, rev(seq_along(cells)), drop = FALSE]
  covariance <- crossprod(matrix(rnorm(k * k), k)) + diag(k) * 0.5
  shift <- matrix(rnorm(g * k, 0, sample(c(0, 0.6, 1.5), 1)), g)
  d <- do.call(rbind, lapply(seq_len(g), function(j) {
    x <- round(rnorm(n[j], 10, 3), 2)
    y <- sweep(matrix(rnorm(n[j] * k), n[j]) %*% chol(covariance) + 0.2 * (x - 10) * kind$x, 2, shift[j, ], "+")
    d <- data.frame(subject = rep(paste0("s", j, "-", seq_len(n[j])), each = k), x = rep(x, each = k),
                    value = round(as.vector(t(y)), 3))
    for (i in seq_along(between)) d[[between[i]]] <- paste0(between[i], groups[j, i])
    for (i in seq_along(within)) d[[within[i]]] <- rep(paste0(within[i], cells[, i]), n[j])
    d
  }))
  column <- function(name) if (name %in% names(d)) d[[name]] else ""
  data_lines <- c(data_lines, sprintf("%d,%s,%s,%s,%s,%s,%s,%.15g", set, d$subject, column("a"), column("b"),
                                      column("u"), column("v"), if (kind$x) d$x else "", d$value))
  for (name in c("subject", between, within)) d[[name]] <- factor(d[[name]], levels = unique(d[[name]]))
  d$x <- d$x - mean(d$x[!duplicated(d$subject)])
  covariate <- if (kind$x) "x" else NULL
  rhs <- paste(c(if (length(between)) paste(between, collapse = "*") else "1", covariate), collapse = " + ")
  error <- if (length(within)) paste0("Error(subject/(", paste(within, collapse = "*"), "))") else "Error(subject)"
  fit <- suppressMessages(suppressWarnings(aov_car(as.formula(paste("value ~", rhs, "+", error)), d, type = 3,
                                                   include_aov = FALSE, factorize = FALSE)))
  ges <- suppressWarnings(anova(fit, es = "ges", correction = "none", intercept = TRUE))
  if (!length(within)) {
    table <- fit$Anova; sse <- table["Residuals", "Sum Sq"]; df2 <- table["Residuals", "Df"]
    for (e in setdiff(rownames(table), "Residuals"))
      effect(set, if (e == "(Intercept)") "intercept" else ours(e), table[e, "Sum Sq"], sse, table[e, "Df"], df2, 1, ges[e, "ges"])
  } else {
    s <- suppressWarnings(summary(fit$Anova, multivariate = FALSE)); u <- s$univariate.tests
    for (e in rownames(u)) {
      eps <- 1
      if (e %in% rownames(s$pval.adjustments) && e %in% rownames(s$sphericity.tests)) {
        a <- s$pval.adjustments; gg <- a[e, "GG eps"]; hf <- min(1, a[e, "HF eps"])
        dims <- round(u[e, "den Df"] / fit$Anova$error.df)
        w <- s$sphericity.tests[e, "Test statistic"]
        key <- function(what) paste("sphericity", ours(e), what, sep = "|")
        put(set, key("gg"), gg); put(set, key("hf"), hf); put(set, key("W"), w)
        violated <- !(fit$Anova$error.df >= dims) || mauchly_p(w, dims, fit$Anova$error.df) < 0.05
        eps <- if (gg <= 0.75) gg else if (violated) hf else 1
      }
      effect(set, if (e == "(Intercept)") "intercept" else ours(e), u[e, "Sum Sq"], u[e, "Error SS"], u[e, "num Df"],
             u[e, "den Df"], eps, ges[e, "ges"])
    }
  }
  all <- interaction(d[c(between, within)], drop = TRUE)
  sd_pooled <- if (is.null(covariate)) sqrt(sum(tapply(d$value, all, function(y) sum((y - mean(y))^2))) /
                                            ((length(unique(d$subject)) - g) * k)) else NA
  for (factor in c(between, within)) {
    grid <- suppressMessages(emmeans(fit, as.formula(paste("~", factor)), model = "multivariate"))
    means <- as.data.frame(summary(grid))
    for (i in seq_len(nrow(means))) {
      put(set, paste("mean", means[i, 1], "mean", sep = "|"), means$emmean[i])
      put(set, paste("mean", means[i, 1], "se", sep = "|"), means$SE[i])
    }
    pairs <- pairs(grid, adjust = "none"); raw <- as.data.frame(summary(pairs))
    adjusted <- lapply(c("holm", "bonferroni", "tukey"), function(by) as.data.frame(summary(pairs, adjust = by))$p.value)
    for (i in seq_len(nrow(raw))) {
      key <- function(what) paste("pair", factor, gsub(" - ", "|", raw$contrast[i]), what, sep = "|")
      put(set, key("difference"), raw$estimate[i]); put(set, key("t"), raw$t.ratio[i]); put(set, key("p"), raw$p.value[i])
      put(set, key("holm"), adjusted[[1]][i]); put(set, key("bonferroni"), adjusted[[2]][i]); put(set, key("tukey"), adjusted[[3]][i])
      if (is.finite(sd_pooled) && abs(raw$t.ratio[i]) < 15) {
        ci <- t_interval(raw$t.ratio[i], raw$df[i]) * raw$SE[i] / sd_pooled
        put(set, key("d"), raw$estimate[i] / sd_pooled); put(set, key("d low"), ci[1]); put(set, key("d high"), ci[2])
      }
    }
  }
  checks(set, d, between, within, covariate)
}

write_to <- function(name, text) {
  file <- gzfile(file.path(folder, name), "w", compression = 9); writeLines(text, file); close(file)
}
write_to("factors-data.csv.gz", data_lines)
write_to("factors-golden.csv.gz", lines)
cat(length(lines) - 1, "figures of 60 data sets\n")
